#include "hierarchy.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "lab/experiments.h"

namespace drape {
namespace {

const std::vector<std::string> parts{"fit", "level", "budget", "break_even", "size"};

/// A column that has a number in the rows of some parts, and may lack one in those of all others.
Column in_parts(const Column& column, const std::vector<std::string>& with) {
    std::vector<std::string> without = parts;
    std::erase_if(without, [&with](const std::string& part) { return std::ranges::find(with, part) != with.end(); });
    return column.or_nan().where("part", without);
}

/// Updates are compared over frames: all of them need the same ones. Tables from before there was `insertion` have none
/// of its rows.
std::string flaw_of_hierarchy_case(const std::vector<HierarchyRow>& rows) {
    const auto key = [](const HierarchyRow& row) { return std::tuple(row.scene, row.volume, row.interval_s); };
    const auto first = names_of<UpdateKind>().front();
    for (const auto& [which, compared] : groups_of(rows_with(rows, &HierarchyRow::part, "break_even"), key)) {
        std::map<std::string, std::vector<double>> frames;
        for (const HierarchyRow& row : compared) frames[row.update].push_back(row.frame);
        for (const std::string& update : names_of<UpdateKind>()) {
            if (update == name_of(UpdateKind::Insertion) && !frames.contains(update)) continue;
            if (frames[update] == frames[first]) continue;
            return "the rows of update '" + update + "' are not of the same frames as those of '" + first + "'";
        }
    }
    return "";
}

}  // namespace

HierarchyRow HierarchyRow::of(const std::string& part, const RecordedMotion& motion,
                              const BroadPhaseParameters& parameters, const std::vector<FrameCounts>& counts) {
    HierarchyRow row;
    row.part = part;
    row.scene = motion.scene;
    row.volume = name_of(parameters.volume);
    row.sphere_fit = parameters.volume == VolumeKind::Sphere ? name_of(parameters.sphere_fit) : "none";
    row.update = name_of(parameters.update);
    row.particles = motion.grid.particles();
    row.leaf_cells = parameters.leaf_cells;
    row.interval_s = motion.interval;
    row.nodes = mean_over_frames(counts, [](const FrameCounts& one) { return one.traversal.nodes; });
    row.visited = mean_over_frames(counts, [](const FrameCounts& one) { return one.traversal.visited; });
    row.candidates = mean_over_frames(counts, &FrameCounts::candidates);
    row.touching = mean_over_frames(counts, &FrameCounts::touching);
    row.false_per_true = drape::false_per_true(counts);
    return row;
}

void HierarchyRow::set_times(const HierarchyRun& run) {
    build = quartiles_over_frames(run, &FrameTimes::build);
    query = quartiles_over_frames(run, &FrameTimes::query);
    exact = quartiles_over_frames(run, &FrameTimes::exact);
    whole = quartiles_over_frames(run, &FrameTimes::whole);
}

std::string HierarchyRow::variant() const {
    return volume == "sphere" && sphere_fit != names_of<SphereFit>().front() ? volume + " " + sphere_fit : volume;
}

RowFormat<HierarchyRow> hierarchy_format() {
    using Row = HierarchyRow;
    const auto timed = [](const char* name) {
        return in_parts(number_column(name), {"fit", "level", "budget", "size"});
    };
    return {
        8,
        {{word_column("part", parts), &Row::part},
         {word_column("scene", names_in(hierarchy_scenes, &HierarchyScene::name)), &Row::scene},
         {name_column<VolumeKind>("volume"), &Row::volume},
         {name_column<SphereFit>("sphere_fit", {"none"}), &Row::sphere_fit},
         {name_column<UpdateKind>("update"), &Row::update},
         {whole_column("particles", 4), &Row::particles},
         {whole_column("leaf_cells"), &Row::leaf_cells},
         {in_parts(whole_column("level"), {"level"}), &Row::level},
         {in_parts(whole_column("tests"), {}), &Row::tests},
         {number_column("interval_s"), &Row::interval_s},
         {in_parts(whole_column("frame"), {"break_even"}), &Row::frame},
         {timed("build_s"), &Row::build},
         {timed("query_s"), &Row::query},
         {timed("exact_s"), &Row::exact},
         {number_column("whole_s"), &Row::whole, &Quartiles::median},
         {timed("whole_lower_s"), &Row::whole, &Quartiles::lower},
         {timed("whole_upper_s"), &Row::whole, &Quartiles::upper},
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

Experiment hierarchy_experiment() {
    return ExperimentOf<HierarchyRow>{"hierarchy",
                                      "what does a tighter hierarchy cost, and what does it save?",
                                      hierarchy_format(),
                                      {{"", hierarchy_cases, hierarchy_summary, hierarchy_charts}},
                                      flaw_of_hierarchy_case};
}

}  // namespace drape
