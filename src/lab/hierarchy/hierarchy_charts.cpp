#include "hierarchy_charts.h"

#include <algorithm>

#include "hierarchy_experiment.h"
#include "hierarchy_parts.h"
#include "hierarchy_summary.h"

namespace drape {

std::vector<std::string> scenes_of(const std::vector<HierarchyRow>& rows) {
    std::vector<std::string> scenes;
    for (const HierarchyRow& row : rows) {
        if (std::ranges::find(scenes, row.scene) == scenes.end()) scenes.push_back(row.scene);
    }
    return scenes;
}

std::vector<Chart> hierarchy_charts(const std::vector<TableRow>& rows) {
    const ChartTable table(hierarchy_columns(), rows);
    std::vector<Chart> charts;
    std::vector<HierarchyRow> as_they_are, resampled;
    for (const HierarchyRow& row : rows_of_part(rows, "fit")) {
        (row.particles == resampled_particles ? resampled : as_they_are).push_back(row);
    }
    if (!as_they_are.empty()) charts.push_back(fit_chart(table, as_they_are, false));
    if (!resampled.empty()) charts.push_back(fit_chart(table, resampled, true));
    if (!as_they_are.empty()) charts.push_back(sphere_chart(table, as_they_are));
    for (const std::string& scene : scenes_of(rows_of_part(rows, "level"))) charts.push_back(level_chart(table, scene));
    if (const auto part = rows_of_part(rows, "budget"); !part.empty()) charts.push_back(budget_chart(table, part));
    const auto break_evens = rows_of_part(rows, "break_even");
    for (const auto& scene : scenes_of(break_evens)) charts.push_back(break_even_chart(table, break_evens, scene));
    if (const auto part = rows_of_part(rows, "size"); !growths(part).empty()) charts.push_back(size_chart(table, part));
    return charts;
}

}  // namespace drape
