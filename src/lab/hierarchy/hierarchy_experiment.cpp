#include "hierarchy.h"
#include "lab/experiments.h"

namespace drape {

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
    return {8,
            {{word_column("part", {"fit", "level", "budget", "break_even", "size"}), &Row::part},
             {word_column("scene", names_in(hierarchy_scenes, &HierarchyScene::name)), &Row::scene},
             {name_column<VolumeKind>("volume"), &Row::volume},
             {name_column<SphereFit>("sphere_fit", {"none"}), &Row::sphere_fit},
             {name_column<UpdateKind>("update"), &Row::update},
             {whole_column("particles", 4), &Row::particles},
             {whole_column("leaf_cells"), &Row::leaf_cells},
             {whole_column("level").or_nan(), &Row::level},
             {whole_column("tests").or_nan(), &Row::tests},
             {number_column("interval_s"), &Row::interval_s},
             {whole_column("frame").or_nan(), &Row::frame},
             {number_column("build_s").or_nan(), &Row::build},
             {number_column("query_s").or_nan(), &Row::query},
             {number_column("exact_s").or_nan(), &Row::exact},
             {number_column("whole_s"), &Row::whole, &Quartiles::median},
             {number_column("whole_lower_s").or_nan(), &Row::whole, &Quartiles::lower},
             {number_column("whole_upper_s").or_nan(), &Row::whole, &Quartiles::upper},
             {number_column("cumulative_s").or_nan(), &Row::cumulative_s},
             {number_column("cumulative_s_over_rebuild_s").or_nan(), &Row::cumulative_s_over_rebuild_s},
             {number_column("nodes"), &Row::nodes},
             {number_column("visited"), &Row::visited},
             {number_column("candidates"), &Row::candidates},
             {number_column("touching"), &Row::touching},
             {number_column("false_per_true").or_nan(), &Row::false_per_true},
             {number_column("tightness").or_nan(), &Row::tightness},
             {number_column("moved").or_nan(), &Row::moved},
             {number_column("missed_penetration_m").or_nan(), &Row::missed_penetration_m},
             {number_column("false_contacts").or_nan(), &Row::false_contacts},
             {number_column("distance_m").or_nan(), &Row::distance_m}}};
}

Experiment hierarchy_experiment() {
    return ExperimentOf<HierarchyRow>{
        "hierarchy",
        "what does a tighter hierarchy cost, and what does it save?",
        hierarchy_format(),
        {{"part", "scene", "particles", "volume"},
         {"whole_s", "false_per_true", "tightness", "missed_penetration_m", "cumulative_s_over_rebuild_s"}},
        {{"", hierarchy_cases, hierarchy_charts}}};
}

}  // namespace drape
