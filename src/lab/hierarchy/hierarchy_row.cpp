#include "hierarchy_row.h"

#include <algorithm>

#include "hierarchy_parts.h"

namespace drape {
namespace {

const std::vector<std::string> parts{"fit", "level", "budget", "break_even", "size"};

/// A column that has a number in the rows of some parts, and may lack one in those of all others.
Column in_parts(const Column& column, const std::vector<std::string>& with) {
    std::vector<std::string> without = parts;
    std::erase_if(without, [&with](const std::string& part) { return std::ranges::find(with, part) != with.end(); });
    return column.or_nan().where("part", without);
}

std::vector<std::string> names(std::span<const std::string> all) { return {all.begin(), all.end()}; }

}  // namespace

HierarchyRow HierarchyRow::of(const std::string& part, const RecordedMotion& motion,
                              const BroadPhaseParameters& parameters) {
    HierarchyRow row;
    row.part = part;
    row.scene = motion.scene;
    row.volume = name_of(parameters.volume);
    row.sphere_fit = parameters.volume == VolumeKind::Sphere ? name_of(parameters.sphere_fit) : "none";
    row.update = name_of(parameters.update);
    row.particles = motion.grid.particles();
    row.leaf_cells = parameters.leaf_cells;
    row.interval_s = motion.interval;
    return row;
}

void HierarchyRow::set_times(const HierarchyRun& run) {
    const auto set = [&run](double (*time)(const FrameTimes&), double& lower, double& median, double& upper) {
        const Quartiles quartiles = quartiles_over_frames(run, time);
        lower = quartiles.lower, median = quartiles.median, upper = quartiles.upper;
    };
    set([](const FrameTimes& t) { return t.build; }, build_lower_s, build_s, build_upper_s);
    set([](const FrameTimes& t) { return t.query; }, query_lower_s, query_s, query_upper_s);
    set([](const FrameTimes& t) { return t.exact; }, exact_lower_s, exact_s, exact_upper_s);
    set([](const FrameTimes& t) { return t.whole(); }, whole_lower_s, whole_s, whole_upper_s);
}

void HierarchyRow::set_counts(const std::vector<FrameCounts>& counts) {
    const auto mean = [&counts](auto count) {
        double sum = 0;
        for (const FrameCounts& one : counts) sum += static_cast<double>(count(one));
        return sum / static_cast<double>(counts.size());
    };
    nodes = mean([](const FrameCounts& one) { return one.traversal.nodes; });
    visited = mean([](const FrameCounts& one) { return one.traversal.visited; });
    candidates = mean([](const FrameCounts& one) { return one.candidates; });
    touching = mean([](const FrameCounts& one) { return one.touching; });
    false_per_true = drape::false_per_true(counts);
}

std::string HierarchyRow::variant() const {
    return volume == "sphere" && sphere_fit != names_of<SphereFit>().front() ? volume + " " + sphere_fit : volume;
}

RowFormat<HierarchyRow> hierarchy_format() {
    using Row = HierarchyRow;
    std::vector<std::string> scenes, fits = names(names_of<SphereFit>());
    for (const HierarchyScene& scene : hierarchy_scenes) scenes.emplace_back(scene.name);
    fits.emplace_back("none");
    const auto timed = [](const char* name) {
        return in_parts(number_column(name), {"fit", "level", "budget", "size"});
    };
    return {
        8,
        {{word_column("part", parts), &Row::part},
         {word_column("scene", scenes), &Row::scene},
         {word_column("volume", names(names_of<VolumeKind>())), &Row::volume},
         {word_column("sphere_fit", fits), &Row::sphere_fit},
         {word_column("update", names(names_of<UpdateKind>())), &Row::update},
         {whole_column("particles", 4), &Row::particles},
         {whole_column("leaf_cells"), &Row::leaf_cells},
         {in_parts(whole_column("level"), {"level"}), &Row::level},
         {in_parts(whole_column("tests"), {}), &Row::tests},
         {number_column("interval_s"), &Row::interval_s},
         {in_parts(whole_column("frame"), {"break_even"}), &Row::frame},
         {timed("build_s"), &Row::build_s},
         {timed("build_lower_s"), &Row::build_lower_s},
         {timed("build_upper_s"), &Row::build_upper_s},
         {timed("query_s"), &Row::query_s},
         {timed("query_lower_s"), &Row::query_lower_s},
         {timed("query_upper_s"), &Row::query_upper_s},
         {timed("exact_s"), &Row::exact_s},
         {timed("exact_lower_s"), &Row::exact_lower_s},
         {timed("exact_upper_s"), &Row::exact_upper_s},
         {number_column("whole_s"), &Row::whole_s},
         {timed("whole_lower_s"), &Row::whole_lower_s},
         {timed("whole_upper_s"), &Row::whole_upper_s},
         {in_parts(number_column("cumulative_s"), {"break_even"}), &Row::cumulative_s},
         {in_parts(number_column("cumulative_s_over_rebuild_s"), {"break_even"}), &Row::cumulative_s_over_rebuild_s},
         {number_column("nodes"), &Row::nodes},
         {number_column("visited"), &Row::visited},
         {number_column("candidates"), &Row::candidates},
         {number_column("touching"), &Row::touching},
         {in_parts(number_column("false_per_true"), {}), &Row::false_per_true},
         {in_parts(number_column("tightness"), {}), &Row::tightness},
         {in_parts(number_column("moved"), {"break_even"}), &Row::moved},
         {in_parts(number_column("missed_penetration_m"), {"budget"}), &Row::missed_penetration_m},
         {in_parts(number_column("false_contacts"), {"budget"}), &Row::false_contacts},
         {in_parts(number_column("distance_m"), {"budget"}), &Row::distance_m}}};
}

}  // namespace drape
