#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <optional>
#include <unistd.h>

#include "drape/base/child_program.h"
#include "drape/base/input_error.h"
#include "drape/base/numbers.h"
#include "drape/base/resources.h"
#include "drape/base/run_program.h"
#include "drape/scene/scene.h"
#include "drape/scene/setting_table.h"
#include "drape/sim/simulation.h"
#include "lab/experiments.h"
#include "lab/hierarchy/hierarchy_run.h"
#include "original.h"

namespace drape {
namespace {

constexpr const char* original_scene = "original";
constexpr double frame_rate = 60;  // frames per simulated second, as drape-capture's
constexpr const char* picture_size = "640x480";

/// CPU times of one build, search and exact test, medians over frames [s], and the cells that a search hands to the
/// test.
/// @param prefix of the columns
Row time_search(const std::string& prefix, const RecordedMotion& motion, const BroadPhaseParameters& parameters,
                int passes) {
    const auto hierarchy = make_broad_phase(parameters, motion.grid);
    const HierarchyRun run = follow(motion, *hierarchy, {.repeats = passes});
    return {{prefix + "build_s", quartiles_over_frames(run, &FrameTimes::build).median},
            {prefix + "search_s", quartiles_over_frames(run, &FrameTimes::query).median},
            {prefix + "exact_s", quartiles_over_frames(run, &FrameTimes::exact).median},
            {prefix + "candidates", mean_over_frames(run.counts, &FrameCounts::candidates)}};
}

/// The medians of some columns of a table of numbers, whose first line after comments has their names.
/// @param first row that counts
std::vector<double> column_medians(const std::filesystem::path& file, const std::vector<std::string>& columns,
                                   int first) {
    std::ifstream in(file);
    std::string names, line;
    while (std::getline(in, names) && names.starts_with('#')) {
    }
    const auto all = split_at_commas(names);
    std::vector<std::vector<double>> values(columns.size());
    for (int row = 0; std::getline(in, line); ++row) {
        const auto cells = parse_reals(line);
        if (!cells) throw RunError(file.string() + ": is not a table of numbers");
        for (std::size_t k = 0; k < columns.size() && row >= first; ++k) {
            const auto number = static_cast<std::size_t>(std::ranges::find(all, columns[k]) - all.begin());
            if (number >= cells->size()) throw RunError(file.string() + ": has no column " + columns[k]);
            values[k].push_back((*cells)[number]);
        }
    }
    std::vector<double> medians;
    for (auto& column : values) {
        if (column.empty()) throw RunError(file.string() + ": has too few rows");
        medians.push_back(quartiles_of(std::move(column)).median);
    }
    return medians;
}

/// What is set in the scene: a ball that the cloth lies on, a hierarchy rebuilt in every step, nothing saved where
/// nothing moves.
std::vector<std::string> original_assignments(const OriginalWay& way) {
    return {"ball.position=0,-0.18,0",
            "volume=" + way.volume,
            "update=rebuild",
            "sphere_fit=centroid",
            "sleep_speed=0",
            "contact.self=false",
            std::string("view.bounds=") + (way.bounds_drawn ? "true" : "false")};
}

/// Measures what simulating takes, without drawing.
Row time_original(const OriginalWay& way, const OriginalPlan& plan) {
    Settings settings = load_scene(original_scene);
    assign_all(settings, original_assignments(way));
    const auto steps = static_cast<int>(std::lround(1 / (frame_rate * settings.solver.dt)));

    Simulation simulation(original_scene, settings);
    std::vector<double> frames;
    for (int frame = 0; frame < plan.first + plan.frames; ++frame) {
        const double seconds = cpu_time_of([&] {
            for (int k = 0; k < steps; ++k) simulation.step();
        });
        if (frame >= plan.first) frames.push_back(seconds);
    }
    if (simulation.report().contacts == 0) throw RunError("original: the cloth does not lie on the ball");

    const RecordedMotion motion =
        record_motion({original_scene, plan.first / frame_rate, 1 / frame_rate, std::max(plan.frames, 2)}, settings);
    BroadPhaseParameters parameters = broad_phase_of(settings);
    Row row{{"volume", way.volume},
            {"bounds_drawn", way.bounds_drawn ? "1" : "0"},
            {"execution_s", quartiles_of(std::move(frames))}};
    row.set(time_search("", motion, parameters, plan.passes));
    parameters.leaf_cells = 1;
    row.set(time_search("single_", motion, parameters, plan.passes));
    return row;
}

}  // namespace

bool draw_original(const OriginalWay& way, const OriginalPlan& plan, const std::filesystem::path& program, Row& row) {
    std::string stats = (std::filesystem::temp_directory_path() / "drape-XXXXXX").string();
    const int made = mkstemp(stats.data());
    if (made < 0) throw RunError(stats + ": cannot be made");
    close(made);
    const std::shared_ptr<void> removed_at_the_end(nullptr, [&stats](void*) { unlink(stats.c_str()); });
    const std::string frames = std::to_string(plan.first + plan.frames), rate = real_text(frame_rate);
    std::vector<std::string> words{program.string(), original_scene, "--frames", frames, "--fps", rate,
                                   "--size",         picture_size,   "--stats",  stats,  "--set"};
    for (const std::string& assignment : original_assignments(way)) words.push_back(assignment);
    const auto code = run_child(words);
    if (!code) return false;
    if (*code != 0) throw RunError(program.string() + " failed on the scene " + original_scene);
    const auto medians = column_medians(stats, {"rate", "gl_calls", "cpu", "vertices"}, plan.first);
    row.set({{"rate_per_s", medians[0]}, {"gl_calls", medians[1]}, {"cpu", medians[2]}, {"vertices", medians[3]}});
    return true;
}

Rows original_rows(const OriginalPlan& plan, const std::filesystem::path& program, bool& draws) {
    Rows rows;
    // What is compared is timed close together: the clock of a processor that others use comes and goes
    for (const OriginalWay& way : original_ways) rows.push_back(time_original(way, plan));
    draws = true;
    for (std::size_t k = 0; k < rows.size() && draws; ++k) {
        draws = draw_original(original_ways[k], plan, program, rows[k]);
    }
    return rows;
}

namespace {

/// What a bar of the chart shows, in the unit that the chart says.
struct Figure {
    int test;
    const char* column;
    double factor;  ///< from the table's unit
    int digits;
};

/// The dissertation's five tests, each without the bounds in the picture and with them.
constexpr Figure five_tests[] = {{1, "execution_s", 1e3, 4},
                                 {2, "rate_per_s", 1, 3},
                                 {3, "gl_calls", 1, 6},
                                 {4, "cpu", 100, 3},
                                 {5, "vertices", 1, 6}};

/// Build and search, which are timed without drawing, with the scene's leaves and down to single cells.
constexpr Figure searches_alone[] = {
    {6, "build_s", 1e6, 2}, {6, "search_s", 1e6, 2}, {6, "single_build_s", 1e6, 2}, {6, "single_search_s", 1e6, 2}};

/// A bar over the rows of a volume; nothing where no row has the figure.
/// @param drawn only of rows with or without bounds in the picture
std::string bar(const Rows& rows, const Figure& figure, int position, const std::string& volume,
                std::optional<bool> drawn) {
    std::vector<double> values;
    for (const Row& row : rows_with(rows, "volume", volume)) {
        if (drawn && row.word("bounds_drawn") != (*drawn ? "1" : "0")) continue;
        if (const double value = row.number(figure.column); !std::isnan(value)) values.push_back(value);
    }
    if (values.empty()) return "";
    const auto [lower, median, upper] = quartiles_of(std::move(values));
    const double factor = figure.factor;
    return fmt::format("{},{},{},{},{:.8g},{:.8g},{:.8g},{:.{}g}\n", figure.test, position, volume,
                       drawn.value_or(false) ? 1 : 0, factor * median, factor * lower, factor * upper, factor * median,
                       figure.digits);
}

std::vector<Chart> original_charts(const Rows& rows) {
    std::string bars = "test,position,volume,drawn,median,lower,upper,text\n";
    for (const Figure& test : five_tests) {
        for (int position = 0; const OriginalWay& way : original_ways) {
            bars += bar(rows, test, position++, way.volume, way.bounds_drawn);
        }
    }
    for (int position = 0; const Figure& search : searches_alone) {
        for (const char* volume : {"sphere", "aabb"}) bars += bar(rows, search, position++, volume, {});
        ++position;
    }
    return {
        {"original",
         "One build and one search, with the scene's leaves of 7 x 7 cells and with a tree down to single cells; the "
         "CPU time of all steps of a frame, without drawing; and the frame rate. Medians over runs, with quartiles. "
         "Hatched: the bounds of a level are in the picture, as the original drew its spheres.",
         {},
         bars}};
}

ExperimentCases original_cases(bool quick) {
    const OriginalPlan plan{.frames = quick ? 12 : 40, .passes = quick ? 5 : 15};
    const auto told = std::make_shared<bool>(false);
    const auto run = [plan, told] {
        const auto program = program_folder() / "drape-capture";
        bool draws = false;
        auto rows = original_rows(plan, program, draws);
        if (!draws && !*told) {
            tell("There is no " + program.string() + ": frame rate, calls, CPU use and vertices stay empty.");
            *told = true;
        }
        return rows;
    };
    return ExperimentCases(quick ? 3 : 7, run);
}

}  // namespace

Experiment original_experiment() {
    const auto if_drawn = [](const char* name) { return number_column(name).or_words({""}); };
    return {"original",
            "spheres or boxes: do the dissertation's five tests come out as they did?",
            8,
            {word_column("volume", {"sphere", "aabb"}), word_column("bounds_drawn", {"0", "1"}),
             number_column("execution_s").with_quartiles(),  // CPU time of all steps of a frame
             if_drawn("rate_per_s"),
             if_drawn("gl_calls"),  // of a frame
             if_drawn("cpu"),       // processor time over wall time: more than 1 where several threads draw
             if_drawn("vertices"), number_column("build_s"), number_column("search_s"), number_column("exact_s"),
             number_column("candidates"), number_column("single_build_s"), number_column("single_search_s"),
             number_column("single_exact_s"), number_column("single_candidates")},
            {{"volume", "bounds_drawn"},
             {"execution_s", "rate_per_s", "gl_calls", "cpu", "vertices", "build_s", "search_s", "single_build_s",
              "single_search_s"}},
            {{"", original_cases, original_charts}}};
}

}  // namespace drape
