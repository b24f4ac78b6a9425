#include "original_frames.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>

#include "drape/base/child_program.h"
#include "drape/base/input_error.h"
#include "drape/base/numbers.h"
#include "drape/base/scratch_folder.h"
#include "drape/sim/scene.h"
#include "drape/sim/setting_table.h"
#include "drape/sim/simulation.h"

namespace drape {
namespace {

constexpr const char* scene = "original";
constexpr double frame_rate = 60;  // frames per simulated second, as drape-capture's
constexpr const char* picture_size = "640x480";

OriginalSearch time_search(const RecordedMotion& motion, const BroadPhaseParameters& parameters, int passes) {
    const auto hierarchy = make_broad_phase(parameters, motion.grid);
    const HierarchyRun run = follow(motion, *hierarchy, {.repeats = passes});
    const auto median = [&run](double (*time)(const FrameTimes&)) { return quartiles_over_frames(run, time).median; };
    OriginalSearch found{.build = median([](const FrameTimes& frame) { return frame.build; }),
                         .search = median([](const FrameTimes& frame) { return frame.query; }),
                         .exact = median([](const FrameTimes& frame) { return frame.exact; })};
    for (const FrameCounts& frame : run.counts) {
        found.candidates += static_cast<double>(frame.candidates) / static_cast<double>(run.counts.size());
    }
    return found;
}

/// Columns of a table whose first line after comments has their names, and whose other lines are numbers.
class NumberTable {
public:
    explicit NumberTable(const std::filesystem::path& file) : name_(file.string()) {
        std::ifstream in(file);
        while (std::getline(in, names_) && names_.starts_with('#')) {
        }
        for (std::string line; std::getline(in, line);) {
            auto row = parse_reals(line);
            if (!row) throw RunError(name_ + ": is not a table of numbers");
            rows_.push_back(std::move(*row));
        }
    }

    /// The median of a column, from a row on.
    [[nodiscard]] double median(const std::string& column, int first) const {
        const auto names = split_at_commas(names_);
        const auto number = static_cast<std::size_t>(std::ranges::find(names, column) - names.begin());
        if (number == names.size()) throw RunError(name_ + ": has no column " + column);
        std::vector<double> values;
        for (auto row = static_cast<std::size_t>(first); row < rows_.size(); ++row) {
            values.push_back(rows_[row].at(number));
        }
        if (values.empty()) throw RunError(name_ + ": has too few rows");
        return quartiles_of(std::move(values)).median;
    }

private:
    std::string name_, names_;
    std::vector<std::vector<double>> rows_;
};

}  // namespace

std::vector<std::string> original_assignments(const OriginalWay& way) {
    return {"ball.position=0,-0.18,0",
            "volume=" + way.volume,
            "update=rebuild",
            "sphere_fit=centroid",
            "coherence=false",
            "sleep_speed=0",
            std::string("view.bounds=") + (way.bounds_drawn ? "true" : "false")};
}

OriginalTimes time_original(const OriginalWay& way, const OriginalPlan& plan) {
    Settings settings = load_scene(scene);
    assign_all(settings, original_assignments(way));
    const auto steps = static_cast<int>(std::lround(1 / (frame_rate * settings.solver.dt)));

    Simulation simulation(scene, settings);
    std::vector<double> frames;
    for (int frame = 0; frame < plan.first + plan.frames; ++frame) {
        const double before = thread_cpu_time();
        for (int k = 0; k < steps; ++k) simulation.step();
        if (frame >= plan.first) frames.push_back(thread_cpu_time() - before);
    }
    if (simulation.report().contacts == 0) throw RunError("original: the cloth does not lie on the ball");

    const RecordedMotion motion = record_motion({.scene = scene,
                                                 .from = plan.first / frame_rate,
                                                 .interval = 1 / frame_rate,
                                                 .frames = std::max(plan.frames, 2)},
                                                settings);
    BroadPhaseParameters parameters = broad_phase_of(settings);
    OriginalTimes times{.execution = quartiles_of(std::move(frames)),
                        .scene = time_search(motion, parameters, plan.passes),
                        .single = {}};
    parameters.leaf_cells = 1;
    times.single = time_search(motion, parameters, plan.passes);
    return times;
}

std::optional<OriginalPictures> draw_original(const OriginalWay& way, const OriginalPlan& plan,
                                              const std::filesystem::path& program) {
    const ScratchFolder folder;
    const std::filesystem::path stats = folder.path() / "stats.csv";
    std::vector<std::string> words{program.string(), scene,
                                   "--frames",       std::to_string(plan.first + plan.frames),
                                   "--fps",          real_text(frame_rate),
                                   "--size",         picture_size,
                                   "--stats",        stats.string(),
                                   "--set"};
    for (const std::string& assignment : original_assignments(way)) words.push_back(assignment);
    const auto code = run_child(words);
    if (!code) return std::nullopt;
    if (*code != 0) throw RunError(program.string() + " failed on the scene " + scene);
    const NumberTable table(stats);
    const auto median = [&](const char* column) { return table.median(column, plan.first); };
    return OriginalPictures{
        .rate = median("rate"), .gl_calls = median("gl_calls"), .cpu = median("cpu"), .vertices = median("vertices")};
}

}  // namespace drape
