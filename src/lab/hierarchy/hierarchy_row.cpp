#include "hierarchy_row.h"

#include <array>

#include "drape/base/numbers.h"

namespace drape {
namespace {

struct TextColumn {
    const char* name;
    std::string HierarchyRow::*text;
};

struct NumberColumn {
    const char* name;
    double HierarchyRow::*number;
};

using Row = HierarchyRow;

constexpr std::array texts{TextColumn{"part", &Row::part}, TextColumn{"scene", &Row::scene},
                           TextColumn{"volume", &Row::volume}, TextColumn{"sphere_fit", &Row::sphere_fit},
                           TextColumn{"update", &Row::update}};

constexpr std::array numbers{NumberColumn{"particles", &Row::particles},
                             NumberColumn{"leaf_cells", &Row::leaf_cells},
                             NumberColumn{"level", &Row::level},
                             NumberColumn{"tests", &Row::tests},
                             NumberColumn{"interval_s", &Row::interval_s},
                             NumberColumn{"frame", &Row::frame},
                             NumberColumn{"build_s", &Row::build_s},
                             NumberColumn{"build_lower_s", &Row::build_lower_s},
                             NumberColumn{"build_upper_s", &Row::build_upper_s},
                             NumberColumn{"query_s", &Row::query_s},
                             NumberColumn{"query_lower_s", &Row::query_lower_s},
                             NumberColumn{"query_upper_s", &Row::query_upper_s},
                             NumberColumn{"exact_s", &Row::exact_s},
                             NumberColumn{"exact_lower_s", &Row::exact_lower_s},
                             NumberColumn{"exact_upper_s", &Row::exact_upper_s},
                             NumberColumn{"whole_s", &Row::whole_s},
                             NumberColumn{"whole_lower_s", &Row::whole_lower_s},
                             NumberColumn{"whole_upper_s", &Row::whole_upper_s},
                             NumberColumn{"cumulative_s", &Row::cumulative_s},
                             NumberColumn{"cumulative_s_over_rebuild_s", &Row::cumulative_s_over_rebuild_s},
                             NumberColumn{"nodes", &Row::nodes},
                             NumberColumn{"visited", &Row::visited},
                             NumberColumn{"candidates", &Row::candidates},
                             NumberColumn{"touching", &Row::touching},
                             NumberColumn{"false_per_true", &Row::false_per_true},
                             NumberColumn{"tightness", &Row::tightness},
                             NumberColumn{"moved", &Row::moved},
                             NumberColumn{"missed_penetration_m", &Row::missed_penetration_m},
                             NumberColumn{"false_contacts", &Row::false_contacts},
                             NumberColumn{"distance_m", &Row::distance_m}};

}  // namespace

HierarchyRow HierarchyRow::of(const std::string& part, const RecordedMotion& motion,
                              const BroadPhaseParameters& parameters) {
    HierarchyRow row;
    row.part = part;
    row.scene = motion.scene;
    row.volume = volume_names()[static_cast<std::size_t>(parameters.volume)];
    row.sphere_fit = parameters.volume == VolumeKind::Sphere
                         ? sphere_fit_names()[static_cast<std::size_t>(parameters.sphere_fit)]
                         : "none";
    row.update = update_names()[static_cast<std::size_t>(parameters.update)];
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
    return volume == "sphere" && sphere_fit != sphere_fit_names().front() ? volume + " " + sphere_fit : volume;
}

std::vector<std::string> hierarchy_columns() {
    std::vector<std::string> names;
    for (const TextColumn& column : texts) names.emplace_back(column.name);
    for (const NumberColumn& column : numbers) names.emplace_back(column.name);
    return names;
}

TableRow to_table(const HierarchyRow& row) {
    TableRow cells;
    for (const TextColumn& column : texts) cells.push_back(row.*column.text);
    for (const NumberColumn& column : numbers) cells.push_back(real_text(row.*column.number, 8));
    return cells;
}

HierarchyRow from_table(const TableRow& row) {
    HierarchyRow read;
    auto cell = row.begin();
    for (const TextColumn& column : texts) read.*column.text = *cell++;
    for (const NumberColumn& column : numbers) read.*column.number = parse_real(*cell++).value();
    return read;
}

}  // namespace drape
