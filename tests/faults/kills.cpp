// SIGKILL at random times: what is there afterwards is whole, and the next run goes on as if nothing had been.

#include <algorithm>
#include <chrono>

#include "faults/fault.h"
#include "support/process.h"

namespace drape::faults {
namespace {

namespace fs = std::filesystem;
using test::names_in;

double seconds_of(const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Every frame in `folder` has the bytes of the frame of that name in `whole`, none but these names are frames.
bool frames_are_whole(const fs::path& folder, const fs::path& whole) {
    const auto names = names_in(folder);
    return std::ranges::all_of(names, [&](const std::string& name) {
        const bool frame = name.starts_with("frame_") && name.ends_with(".png");
        return !frame || test::read_file(folder / name) == test::read_file(whole / name);
    });
}

/// A table without its date, for a run may last over midnight.
std::string undated(const std::string& table) {
    const std::size_t begin = table.find("# date: ");
    return begin == std::string::npos ? table : table.substr(0, begin) + table.substr(table.find('\n', begin));
}

}  // namespace

void kill_capture(Trial& trial, int count) {
    const std::string command = "$CAPTURE drop --frames 8 --size 96x54 --stats stats.csv --again --out ";
    Outcome outcome;
    const double time = seconds_of([&] { outcome = trial.run(command + "whole"); });
    if (!trial.check(outcome.code == 0, "the run that the others are held to", outcome)) return;
    const auto frames = names_in(trial.path("whole"));
    for (int k = 0; k < count; ++k) {
        outcome = trial.run_and_kill(command + "cut", trial.random() * 1.2 * time);
        trial.check(frames_are_whole(trial.path("cut"), trial.path("whole")), "every frame is whole", outcome);
        // Now and then the next run is left alone: nothing of the killed ones stays
        if (k % 10 == 9 || k + 1 == count) {
            outcome = trial.run(command + "cut");
            const bool same = names_in(trial.path("cut")) == frames;
            trial.check(outcome.code == 0 && same && frames_are_whole(trial.path("cut"), trial.path("whole")),
                        "the next run has all frames and leaves nothing else", outcome);
            trial.remove("cut");
        }
    }
    trial.remove("whole");
}

void kill_experiments(Trial& trial, int count) {
    // Charts take longer than the cases: they are drawn once in a while
    const std::string plain = "env PATH=/nonexistent $LAB stability --quick --cases 1-6 --out ";
    const std::string drawn = "$LAB stability --quick --cases 1-6 --out ";
    Outcome outcome;
    const double time = seconds_of([&] { outcome = trial.run("exec " + plain + "whole"); });
    if (!trial.check(outcome.code == 0, "the run that the others are held to", outcome)) return;
    outcome = trial.run(drawn + "whole");
    const auto files = names_in(trial.path("whole"));
    const std::string table = undated(trial.text("whole/stability.csv"));
    for (int k = 0; k < count; ++k) {
        outcome = trial.run_and_kill((k % 10 == 5 ? drawn : plain) + "cut", trial.random() * 1.2 * time);
        if (k % 3 != 2 && k + 1 != count) continue;
        outcome = trial.run(drawn + "cut");
        trial.check(outcome.code == 0 && undated(trial.text("cut/stability.csv")) == table,
                    "a run that went on has the table of one that was never killed", outcome);
        trial.check(names_in(trial.path("cut")) == files, "the next run leaves nothing else", outcome);
        trial.remove("cut");
    }
    trial.remove("whole");
}

}  // namespace drape::faults
