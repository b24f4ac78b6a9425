#include "hierarchy_row.h"

#include <array>

#include "drape/base/numbers.h"
#include "hierarchy_parts.h"

namespace drape {
namespace {

struct TextColumn {
    const char* name;
    std::string HierarchyRow::*text;
};

/// The parts whose rows must have a number in a column. In the rows of others it may be nan.
enum class In { All, Level, Budget, BreakEven, AllButBreakEven, None };

struct NumberColumn {
    const char* name;
    double HierarchyRow::*number;
    In in = In::All;
    bool whole = false;
    double least = 0;
};

using Row = HierarchyRow;

constexpr std::array texts{TextColumn{"part", &Row::part}, TextColumn{"scene", &Row::scene},
                           TextColumn{"volume", &Row::volume}, TextColumn{"sphere_fit", &Row::sphere_fit},
                           TextColumn{"update", &Row::update}};

constexpr std::array numbers{
    NumberColumn{"particles", &Row::particles, In::All, true, 4},
    NumberColumn{"leaf_cells", &Row::leaf_cells, In::All, true},
    NumberColumn{"level", &Row::level, In::Level, true},
    NumberColumn{"tests", &Row::tests, In::None, true},
    NumberColumn{"interval_s", &Row::interval_s},
    NumberColumn{"frame", &Row::frame, In::BreakEven, true},
    NumberColumn{"build_s", &Row::build_s, In::AllButBreakEven},
    NumberColumn{"build_lower_s", &Row::build_lower_s, In::AllButBreakEven},
    NumberColumn{"build_upper_s", &Row::build_upper_s, In::AllButBreakEven},
    NumberColumn{"query_s", &Row::query_s, In::AllButBreakEven},
    NumberColumn{"query_lower_s", &Row::query_lower_s, In::AllButBreakEven},
    NumberColumn{"query_upper_s", &Row::query_upper_s, In::AllButBreakEven},
    NumberColumn{"exact_s", &Row::exact_s, In::AllButBreakEven},
    NumberColumn{"exact_lower_s", &Row::exact_lower_s, In::AllButBreakEven},
    NumberColumn{"exact_upper_s", &Row::exact_upper_s, In::AllButBreakEven},
    NumberColumn{"whole_s", &Row::whole_s},
    NumberColumn{"whole_lower_s", &Row::whole_lower_s, In::AllButBreakEven},
    NumberColumn{"whole_upper_s", &Row::whole_upper_s, In::AllButBreakEven},
    NumberColumn{"cumulative_s", &Row::cumulative_s, In::BreakEven},
    NumberColumn{"cumulative_s_over_rebuild_s", &Row::cumulative_s_over_rebuild_s, In::BreakEven},
    NumberColumn{"nodes", &Row::nodes},
    NumberColumn{"visited", &Row::visited},
    NumberColumn{"candidates", &Row::candidates},
    NumberColumn{"touching", &Row::touching},
    NumberColumn{"false_per_true", &Row::false_per_true, In::None},
    NumberColumn{"tightness", &Row::tightness, In::None},
    NumberColumn{"moved", &Row::moved, In::BreakEven},
    NumberColumn{"missed_penetration_m", &Row::missed_penetration_m, In::Budget},
    NumberColumn{"false_contacts", &Row::false_contacts, In::Budget},
    NumberColumn{"distance_m", &Row::distance_m, In::Budget}};

const std::vector<std::string> parts{"fit", "level", "budget", "break_even", "size"};

/// The parts in whose rows there may be nan.
std::vector<std::string> parts_without(In in) {
    const auto has = [in](const std::string& part) {
        switch (in) {
            case In::Level:
                return part == "level";
            case In::Budget:
                return part == "budget";
            case In::BreakEven:
                return part == "break_even";
            case In::AllButBreakEven:
                return part != "break_even";
            case In::All:
                return true;
            case In::None:
                return false;
        }
        return true;
    };
    std::vector<std::string> without = parts;
    std::erase_if(without, has);
    return without;
}

Column column_of(const NumberColumn& column) {
    const Column filled = column.whole ? whole_column(column.name, column.least) : number_column(column.name);
    return column.in == In::All ? filled : filled.or_nan().where("part", parts_without(column.in));
}

/// What may stand in a column of words.
std::vector<std::string> words_of(const TextColumn& column) {
    std::vector<std::string> words;
    const auto add = [&words](std::span<const std::string> more) {
        words.insert(words.end(), more.begin(), more.end());
    };
    if (column.text == &Row::part) add(parts);
    if (column.text == &Row::volume) add(names_of<VolumeKind>());
    if (column.text == &Row::sphere_fit) add(names_of<SphereFit>()), words.emplace_back("none");
    if (column.text == &Row::update) add(names_of<UpdateKind>());
    if (column.text == &Row::scene) {
        for (const HierarchyScene& scene : hierarchy_scenes) words.emplace_back(scene.name);
    }
    return words;
}

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

std::vector<Column> hierarchy_columns() {
    std::vector<Column> columns;
    for (const TextColumn& column : texts) columns.push_back(word_column(column.name, words_of(column)));
    for (const NumberColumn& column : numbers) columns.push_back(column_of(column));
    return columns;
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
    for (const NumberColumn& column : numbers) read.*column.number = number_in(*cell++);
    return read;
}

}  // namespace drape
