#include "commands.h"

#include <cmath>
#include <iostream>
#include <memory>
#include <vector>

#include "drape/base/input_error.h"
#include "drape/base/numbers.h"
#include "drape/base/output_file.h"
#include "drape/base/run_program.h"
#include "drape/base/stop_signals.h"
#include "drape/base/stopwatch.h"
#include "drape/scene/setting_table.h"
#include "drape/session/failure.h"
#include "drape/session/start.h"
#include "drape/session/state_csv.h"

namespace drape {
namespace {

constexpr double longest_run = 1e6;  // s

struct SimulateOptions {
    StartOptions start;
    std::string times, state, stats;
};

/// "0.5,1,2" as times [s] that go back neither from one to the next nor from that of the start.
/// @param steps_are_known no replay changes their length: times are refused between which none ends
std::vector<double> parse_times(const std::string& text, Session& session, bool steps_are_known) {
    const double start = session.start_time(), dt = session.simulation().settings().solver.dt;
    std::vector<double> times;
    for (const std::string_view word : split_at_commas(text)) {
        const auto time = parse_real(word);
        if (!time || !(*time >= start && *time <= start + longest_run)) {
            throw InputError("--time " + shortened(word) + ": allowed " + real_text(start) +
                             " <= T <= " + real_text(start + longest_run) + " s" +
                             (start > 0 ? ", for the scene starts at t = " + real_text(start) + " s" : ""));
        }
        if (!times.empty() && *time < times.back()) {
            throw InputError("--time " + shortened(word) + ": allowed only times that do not go back");
        }
        const double before = times.empty() ? start : times.back();
        if (steps_are_known && *time > before &&
            std::floor(session.steps_to(*time)) == std::floor(session.steps_to(before))) {
            throw InputError("--time " + shortened(word) + ": no step ends after " + real_text(before) +
                             " s up to then: allowed only times with an end of a step between them, which is every " +
                             real_text(dt) + " s (solver.dt)");
        }
        times.push_back(*time);
    }
    return times;
}

int simulate(SimulateOptions& options) {
    const StopSignals signals;
    const bool whole_replay = options.times.empty() && !options.start.replay.empty();
    if (options.times.empty() && !whole_replay) {
        throw InputError("--time is missing: say --time T[,T2...], or --replay FILE to play a whole recording");
    }
    Start start = make_start(options.start);
    check_written(options.start, start,
                  {{"--state", options.state}, {"--stats", options.stats}, {"--save", options.start.save}});
    const bool replays = start.replay.has_value();
    Session session = make_session(std::move(start));
    const std::vector<double> times =
        whole_replay ? std::vector<double>{} : parse_times(options.times, session, !replays);
    const std::string warning = session.simulation().step_warning();
    if (!warning.empty()) tell("warning: " + warning);
    OutputFile state(options.state), stats(options.stats);
    std::vector<StatsColumn> columns;
    add_report_columns(columns);
    add_ball_columns(columns, session.simulation().balls().size());
    if (state.wanted()) write_state_header(state.stream(), session.simulation());
    if (stats.wanted()) write_stats_head(stats.stream(), columns);

    const Stopwatch watch;
    const auto stop = [&signals] { return signals.arrived() != 0; };
    bool written = false;
    const auto write = [&] {
        if (session.simulation().report().status == Status::Diverged) return false;
        written = true;
        if (state.wanted()) write_state(state.stream(), session.simulation());
        if (stats.wanted()) write_stats_row(stats.stream(), columns, session.view());
        return true;
    };
    if (whole_replay && session.run_replay(stop)) write();
    for (const double time : times) {
        if (!session.run_until(time, stop) || !write()) break;
        if (session.steps_to(time) == 0) continue;
        tell("warning: --time " + real_text(time) + " is within a step: the state is that before it, at " +
             real_text(session.time(), 12) + " s");
    }
    // Told first: the files may not take what is left to write
    const StepReport& report = session.simulation().report();
    if (report.status == Status::Diverged) {
        tell("drape-lab: " + report.error);
        tell(tell_failure(session.simulation(), ""));
    }
    // What was there before is worth more than a table without rows
    if (written) {
        state.close();
        stats.close();
    }
    save_snapshot(options.start.save, session.simulation());

    tell(std::to_string(report.step) + " steps to " + real_text(report.time, 6) + " s in " +
         real_text(watch.seconds(), 3) + " s");
    if (!session.replay_notice().empty()) tell(session.replay_notice());
    if (options.start.hash) std::cout << hash_text(session.simulation().hash()) << "\n";
    const bool is_ok = report.status == Status::Ok;
    for (const std::string& doubt :
         {session.simulation().crossing_warning(), is_ok ? session.simulation().run_warning() : std::string()}) {
        if (!doubt.empty()) tell("warning: " + doubt);
    }
    if (const int signal = signals.arrived()) return 128 + signal;
    return report.status == Status::Ok && !session.replay_differs() ? Done : Failed;
}

}  // namespace

void add_simulate(CommandLine& line, int& exit_code) {
    auto options = std::make_shared<SimulateOptions>();
    CommandLine& command = line.command("simulate", "Runs a scene to given times",
                                        [options, &exit_code] { exit_code = simulate(*options); });
    add_start_options(command, options->start);
    command.option(
        "--time", options->times,
        "simulated times to stop at [s], on the clock of the scene: its start file, if it has one, sets it; a "
        "whole recording if not given",
        {"T[,T2...]"});
    command.option("--state", options->state, "write every particle and ball at each time", {"FILE.csv"});
    command.option("--stats", options->stats, "write the report of the step at each time; its first line has the units",
                   {"FILE.csv"});
    command.footer([] { return "Settings:\n" + settings_help(); });
}

}  // namespace drape
