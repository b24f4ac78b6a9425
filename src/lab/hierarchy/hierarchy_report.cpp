#include "hierarchy.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "drape/base/assert.h"
#include "drape/base/exact_math.h"

namespace drape {
namespace {

std::string scene_and_volume(const HierarchyRow& row) { return row.scene + " " + row.volume; }

/// The hierarchies of least time a frame, scene by scene.
std::string fastest(const HierarchyRows& rows) {
    const auto motion = [](const HierarchyRow& row) { return std::pair(row.scene, row.particles); };
    const auto time = [](const HierarchyRow& row) { return row.whole.median; };
    HierarchyRows trees = rows;
    std::erase_if(trees, [](const HierarchyRow& row) { return row.volume == "brute"; });
    auto brute = groups_of(rows_with(rows, &HierarchyRow::volume, "brute"), motion);
    std::string text;
    for (const auto& [key, tried] : groups_of(trees, motion)) {
        const HierarchyRow best = std::ranges::min(tried, {}, time);
        text += fmt::format("fit: {}, {} particles: fastest is {} {} with leaves of {}, {:.3g} us a frame", best.scene,
                            best.particles, best.variant(), best.update, best.leaf_cells, 1e6 * time(best));
        if (brute.contains(key)) text += fmt::format("; brute force {:.3g} us", 1e6 * time(brute[key][0]));
        text += "\n";
    }
    return text;
}

/// When refitting has cost more in all than rebuilding, at each interval between frames.
std::string break_evens(const HierarchyRows& rows) {
    std::string text;
    for (const auto& [hierarchy, frames] : groups_of(rows, scene_and_volume)) {
        text += fmt::format("break_even: {}: refit has cost more than rebuild, frames", hierarchy);
        for (const auto& [interval, all] : groups_of(frames, &HierarchyRow::interval_s)) {
            std::map<std::string, std::vector<double>> costs;
            for (const HierarchyRow& row : all) costs[row.update].push_back(row.whole.median);
            const auto frame = break_even_frame(costs.at("refit"), costs.at("rebuild"));
            text += fmt::format(" {:.3g} ms apart: {},", 1e3 * interval,
                                frame ? fmt::format("from frame {}", *frame + 1) : "never");
        }
        text.back() = '\n';
    }
    return text;
}

/// What a limited search lets through at its smallest and largest budget.
std::string budgets(HierarchyRows rows) {
    std::erase_if(rows, [](const HierarchyRow& row) { return !(row.tests > 0); });
    const auto end = [](const HierarchyRow& row) {
        return fmt::format("{:.3g} mm missed with {} tests", 1e3 * row.missed_penetration_m, row.tests);
    };
    std::string text;
    for (const auto& [hierarchy, limited] : groups_of(rows, scene_and_volume)) {
        const auto [least, most] = std::ranges::minmax(limited, {}, &HierarchyRow::tests);
        text += fmt::format("budget: {}: {}, {}\n", hierarchy, end(least), end(most));
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

std::vector<Growth> growths(const HierarchyRows& rows) {
    if (rows.empty()) return {};
    const auto [least, most] = std::ranges::minmax(rows, {}, &HierarchyRow::particles);
    const double from = std::sqrt(least.particles * most.particles) * (1 - 1e-9);
    HierarchyRows large = rows;
    std::erase_if(large, [from](const HierarchyRow& row) { return row.particles < from; });
    std::vector<Growth> all;
    for (const auto& [key, sizes] :
         groups_of(large, [](const auto& row) { return std::pair(row.volume, row.update); })) {
        std::set<double> logarithms;
        std::vector<std::pair<double, double>> build, search;
        for (const HierarchyRow& row : sizes) {
            logarithms.insert(natural_log(row.particles));
            // Brute force builds nothing: a time of zero is no power law
            build.emplace_back(row.particles, std::max(row.build.median, 1e-9));
            search.emplace_back(row.particles, row.query.median + row.exact.median);
        }
        if (logarithms.size() < 2) continue;
        all.push_back({key.first, key.second, fit_power_law(build), fit_power_law(search)});
    }
    return all;
}

std::string hierarchy_summary(const HierarchyRows& rows) {
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
