#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <unistd.h>
#include <utility>

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

namespace drape {
namespace {

constexpr const char* original_scene = "original";
constexpr double frame_rate = 60;  // frames per simulated second, as drape-capture's
constexpr const char* picture_size = "640x480";
constexpr int first_frame = 20;  // that is measured: before it the cloth comes to lie on the ball

/// One way in which the original's scene is run.
struct OriginalWay {
    const char* volume;
    bool bounds_drawn;  ///< a level of the hierarchy is in the picture, as in the original
};

/// In the order of the table.
constexpr OriginalWay original_ways[] = {{"sphere", false}, {"aabb", false}, {"sphere", true}, {"aabb", true}};

/// What is set in the scene: a ball that the cloth lies on, a hierarchy rebuilt in every step, nothing saved where
/// nothing moves.
std::vector<std::string> original_assignments(const OriginalWay& way) {
    return {"ball.position=0,-0.18,0",
            std::string("volume=") + way.volume,
            "update=rebuild",
            "sphere_fit=centroid",
            "sleep_speed=0",
            "contact.self=false",
            std::string("view.bounds=") + (way.bounds_drawn ? "true" : "false")};
}

/// CPU times of one build, search and exact test, medians over frames [s], and the cells that a search hands to the
/// test.
/// @param prefix of the columns
Row time_search(const std::string& prefix, const RecordedMotion& motion, const BroadPhaseParameters& parameters,
                int passes) {
    const std::vector<FrameRun> frames =
        follow(motion, *make_broad_phase(parameters, motion.grid), {.repeats = passes});
    return {{prefix + "build_s", quartiles_over(frames, "build_s").median},
            {prefix + "search_s", quartiles_over(frames, "query_s").median},
            {prefix + "exact_s", quartiles_over(frames, "exact_s").median},
            {prefix + "candidates", mean_over(frames, "candidates")}};
}

/// Measures what simulating takes, without drawing.
/// @param count of frames
/// @param passes of these, to time build and search
Row time_original(const OriginalWay& way, int count, int passes) {
    Settings settings = load_scene(original_scene);
    assign_all(settings, original_assignments(way));
    const auto steps = static_cast<int>(std::lround(1 / (frame_rate * settings.solver.dt)));

    Simulation simulation(original_scene, settings);
    std::vector<double> frames;
    for (int frame = 0; frame < first_frame + count; ++frame) {
        const double seconds = cpu_time_of([&] {
            for (int k = 0; k < steps; ++k) simulation.step();
        });
        if (frame >= first_frame) frames.push_back(seconds);
    }
    if (simulation.report().contacts == 0) throw RunError("original: the cloth does not lie on the ball");

    const RecordedMotion motion =
        record_motion({original_scene, first_frame / frame_rate, 1 / frame_rate, count}, settings);
    BroadPhaseParameters parameters = broad_phase_of(settings);
    Row row{{"volume", way.volume},
            {"bounds_drawn", way.bounds_drawn ? "1" : "0"},
            {"execution_s", quartiles_of(std::move(frames))}};
    row.set(time_search("", motion, parameters, passes));
    parameters.leaf_cells = 1;
    row.set(time_search("single_", motion, parameters, passes));
    return row;
}

/// The median over the measured frames of a column of a table of numbers, whose first line after comments has the
/// names.
double column_median(const std::filesystem::path& file, const std::string& column) {
    std::ifstream in(file);
    std::string line;
    while (std::getline(in, line) && line.starts_with('#')) {
    }
    const auto names = split_at_commas(line);
    const auto place = static_cast<std::size_t>(std::ranges::find(names, column) - names.begin());
    std::vector<double> values;
    for (int row = 0; std::getline(in, line); ++row) {
        const auto cells = parse_reals(line);
        if (!cells || place >= cells->size()) throw RunError(file.string() + ": has no numbers in a column " + column);
        if (row >= first_frame) values.push_back((*cells)[place]);
    }
    if (values.empty()) throw RunError(file.string() + ": has too few rows");
    return quartiles_of(std::move(values)).median;
}

/// What `drape-capture` says of the pictures.
/// @throws RunError if it fails, or does not say it
Row draw_original(const OriginalWay& way, int count, const std::filesystem::path& program) {
    std::string stats = (std::filesystem::temp_directory_path() / "drape-XXXXXX").string();
    const int made = mkstemp(stats.data());
    if (made < 0) throw RunError(stats + ": cannot be made");
    close(made);
    const std::shared_ptr<void> removed_at_the_end(nullptr, [&stats](void*) { unlink(stats.c_str()); });
    const std::string frames = std::to_string(first_frame + count), rate = real_text(frame_rate);
    std::vector<std::string> words{program.string(), original_scene, "--frames", frames, "--fps", rate,
                                   "--size",         picture_size,   "--stats",  stats,  "--set"};
    for (const std::string& assignment : original_assignments(way)) words.push_back(assignment);
    if (run_child(words) != 0) throw RunError(program.string() + " failed on the scene " + original_scene);
    const auto median = [&](const char* column) { return column_median(stats, column); };
    return {{"rate_per_s", median("rate")},
            {"gl_calls", median("gl_calls")},
            {"cpu", median("cpu")},
            {"vertices", median("vertices")}};
}

ExperimentCases original_cases(bool quick) {
    const auto run = [frames = quick ? 12 : 40, passes = quick ? 5 : 15, told = std::make_shared<bool>(false)] {
        Rows rows;
        const auto program = program_folder() / "drape-capture";
        if (!exists(program) && !std::exchange(*told, true)) {
            tell("There is no " + program.string() + ": frame rate, calls, CPU use and vertices stay empty.");
        }
        // What is compared is timed close together: the clock of a processor that others use comes and goes
        for (const OriginalWay& way : original_ways) rows.push_back(time_original(way, frames, passes));
        for (std::size_t k = 0; k < rows.size() && exists(program); ++k) {
            rows[k].set(draw_original(original_ways[k], frames, program));
        }
        return rows;
    };
    return ExperimentCases(quick ? 3 : 7, run);
}

}  // namespace

Experiment original_experiment() {
    return {"original",
            "spheres or boxes: do the dissertation's five tests come out as they did?",
            8,
            {"volume", "bounds_drawn",
             quartile_columns("execution_s"),  // CPU time of all steps of a frame
             // Empty where there is nothing that draws
             Column{"rate_per_s", ""}, Column{"gl_calls", ""},  // of a frame
             Column{"cpu", ""},  // processor time over wall time: more than 1 where several threads draw
             Column{"vertices", ""}, "build_s", "search_s", "exact_s", "candidates", "single_build_s",
             "single_search_s", "single_exact_s", "single_candidates"},
            {{"", original_cases, {{"original"}}}}};
}

}  // namespace drape
