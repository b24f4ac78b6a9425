#include "hierarchy_summary.h"

#include <algorithm>
#include <cmath>

#include "break_even.h"
#include "drape/base/exact_math.h"
#include "drape/base/numbers.h"

namespace drape {
namespace {

using Key = std::vector<std::string>;

std::string in_microseconds(double seconds) { return real_text(1e6 * seconds, 3) + " us"; }

/// The hierarchies of least time a frame, scene by scene.
std::string fastest(const std::vector<HierarchyRow>& rows) {
    std::map<std::pair<std::string, double>, const HierarchyRow*> best, brute;
    for (const HierarchyRow& row : rows) {
        const HierarchyRow*& least = (row.volume == "brute" ? brute : best)[{row.scene, row.particles}];
        if (least == nullptr || row.whole_s < least->whole_s) least = &row;
    }
    std::string text;
    for (const auto& [key, row] : best) {
        text += "fit: " + key.first + ", " + real_text(key.second) + " particles: fastest is " + row->variant() + " " +
                row->update + " with leaves of " + real_text(row->leaf_cells) + ", " + in_microseconds(row->whole_s) +
                " a frame";
        if (brute.contains(key)) text += "; brute force " + in_microseconds(brute[key]->whole_s);
        text += "\n";
    }
    return text;
}

/// When refitting has cost more in all than rebuilding, at each interval between frames.
std::string break_evens(const std::vector<HierarchyRow>& rows) {
    std::map<Key, std::map<double, std::map<std::string, std::vector<double>>>> costs;
    for (const HierarchyRow& row : rows) {
        costs[{row.scene, row.volume}][row.interval_s][row.update].push_back(row.whole_s);
    }
    std::string text;
    for (const auto& [key, intervals] : costs) {
        text += "break_even: " + key[0] + " " + key[1] + ": refit has cost more than rebuild, frames";
        for (const auto& [interval, updates] : intervals) {
            const auto frame = break_even_frame(updates.at("refit"), updates.at("rebuild"));
            text += " " + real_text(1e3 * interval, 3) +
                    " ms apart: " + (frame ? "from frame " + std::to_string(*frame + 1) : std::string("never")) + ",";
        }
        text.back() = '\n';
    }
    return text;
}

/// What a limited search lets through at its smallest and largest budget.
std::string budgets(const std::vector<HierarchyRow>& rows) {
    std::map<Key, std::pair<const HierarchyRow*, const HierarchyRow*>> ends;
    for (const HierarchyRow& row : rows) {
        if (!(row.tests > 0)) continue;
        auto& [least, most] = ends[{row.scene, row.volume}];
        if (least == nullptr || row.tests < least->tests) least = &row;
        if (most == nullptr || row.tests > most->tests) most = &row;
    }
    const auto end = [](const HierarchyRow& row) {
        return real_text(1e3 * row.missed_penetration_m, 3) + " mm missed with " + real_text(row.tests) + " tests";
    };
    std::string text;
    for (const auto& [key, rows_at] : ends) {
        text += "budget: " + key[0] + " " + key[1] + ": " + end(*rows_at.first) + ", " + end(*rows_at.second) + "\n";
    }
    return text;
}

}  // namespace

std::vector<HierarchyRow> rows_of_part(const std::vector<TableRow>& rows, const std::string& part) {
    std::vector<HierarchyRow> found;
    for (const TableRow& row : rows) {
        HierarchyRow read = from_table(row);
        if (read.part == part) found.push_back(std::move(read));
    }
    return found;
}

std::vector<Growth> growths(const std::vector<HierarchyRow>& rows) {
    if (rows.empty()) return {};
    const auto [least, most] = std::ranges::minmax(rows, {}, &HierarchyRow::particles);
    const double from = std::sqrt(least.particles * most.particles) * (1 - 1e-9);
    std::map<std::pair<std::string, std::string>, std::vector<const HierarchyRow*>> hierarchies;
    for (const HierarchyRow& row : rows) {
        if (row.particles >= from) hierarchies[{row.volume, row.update}].push_back(&row);
    }
    std::vector<Growth> all;
    for (const auto& [key, sizes] : hierarchies) {
        const auto same = [&](const HierarchyRow* row) {
            return natural_log(row->particles) == natural_log(sizes.front()->particles);
        };
        if (std::ranges::all_of(sizes, same)) continue;
        std::vector<std::pair<double, double>> build, search;
        for (const HierarchyRow* row : sizes) {
            // Brute force builds nothing: a time of zero is no power law
            build.emplace_back(row->particles, std::max(row->build_s, 1e-9));
            search.emplace_back(row->particles, row->query_s + row->exact_s);
        }
        all.push_back({key.first, key.second, fit_power_law(build), fit_power_law(search)});
    }
    return all;
}

std::string hierarchy_summary(const std::vector<TableRow>& rows) {
    std::string text = fastest(rows_of_part(rows, "fit")) + budgets(rows_of_part(rows, "budget")) +
                       break_evens(rows_of_part(rows, "break_even"));
    for (const Growth& growth : growths(rows_of_part(rows, "size"))) {
        text += "size: " + growth.volume + " " + growth.update + ": ";
        if (growth.volume != "brute") {
            text += "build grows as particles^" + real_text(growth.build.exponent, 3) + ", ";
        }
        text += "search as particles^" + real_text(growth.search.exponent, 3) + "\n";
    }
    return text;
}

}  // namespace drape
