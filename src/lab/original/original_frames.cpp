#include "original.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <memory>

#include "drape/base/child_program.h"
#include "drape/base/input_error.h"
#include "drape/base/numbers.h"
#include "drape/scene/scene.h"
#include "drape/scene/setting_table.h"
#include "drape/sim/simulation.h"
#include "lab/hierarchy/hierarchy_run.h"

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

}  // namespace drape
