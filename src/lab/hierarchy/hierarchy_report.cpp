#include "hierarchy_report.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "drape/base/assert.h"
#include "drape/base/exact_math.h"

namespace drape {
namespace {

using Key = std::vector<std::string>;

/// The hierarchies of least time a frame, scene by scene.
std::string fastest(const std::vector<HierarchyRow>& rows) {
    std::map<std::pair<std::string, double>, const HierarchyRow*> best, brute;
    for (const HierarchyRow& row : rows) {
        const HierarchyRow*& least = (row.volume == "brute" ? brute : best)[{row.scene, row.particles}];
        if (least == nullptr || row.whole_s < least->whole_s) least = &row;
    }
    std::string text;
    for (const auto& [key, row] : best) {
        text += fmt::format("fit: {}, {} particles: fastest is {} {} with leaves of {}, {:.3g} us a frame", row->scene,
                            row->particles, row->variant(), row->update, row->leaf_cells, 1e6 * row->whole_s);
        if (brute.contains(key)) text += fmt::format("; brute force {:.3g} us", 1e6 * brute[key]->whole_s);
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
        text += fmt::format("break_even: {} {}: refit has cost more than rebuild, frames", key[0], key[1]);
        for (const auto& [interval, updates] : intervals) {
            const auto frame = break_even_frame(updates.at("refit"), updates.at("rebuild"));
            text += fmt::format(" {:.3g} ms apart: {},", 1e3 * interval,
                                frame ? fmt::format("from frame {}", *frame + 1) : "never");
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
        return fmt::format("{:.3g} mm missed with {} tests", 1e3 * row.missed_penetration_m, row.tests);
    };
    std::string text;
    for (const auto& [key, rows_at] : ends) {
        text += fmt::format("budget: {} {}: {}, {}\n", key[0], key[1], end(*rows_at.first), end(*rows_at.second));
    }
    return text;
}

}  // namespace

std::optional<std::size_t> break_even_frame(std::span<const double> costs, std::span<const double> others) {
    DRAPE_ASSERT(costs.size() == others.size());
    std::optional<std::size_t> since;
    double lead = 0;
    for (std::size_t k = 0; k < costs.size(); ++k) {
        lead += others[k] - costs[k];
        if (!(lead < 0)) {
            since.reset();
        } else if (!since) {
            since = k;
        }
    }
    return since;
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

std::string hierarchy_summary(const std::vector<HierarchyRow>& rows) {
    const auto part = [&rows](const char* name) { return rows_with(rows, &HierarchyRow::part, name); };
    std::string text = fastest(part("fit")) + budgets(part("budget")) + break_evens(part("break_even"));
    for (const Growth& growth : growths(part("size"))) {
        text += fmt::format("size: {} {}: ", growth.volume, growth.update);
        if (growth.volume != "brute") text += fmt::format("build grows as particles^{:.3g}, ", growth.build.exponent);
        text += fmt::format("search as particles^{:.3g}\n", growth.search.exponent);
    }
    return text;
}

}  // namespace drape
