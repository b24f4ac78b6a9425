#include "hierarchy.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "drape/base/exact_math.h"
#include "drape/bounds/node_view.h"

namespace drape {
namespace {

using Charts = std::vector<Chart>;

/// Those of some volumes that rows have.
std::vector<std::string> volumes_in(const HierarchyRows& rows, std::vector<std::string> volumes) {
    std::erase_if(volumes, [&rows](const std::string& volume) {
        return std::ranges::find(rows, volume, &HierarchyRow::volume) == rows.end();
    });
    return volumes;
}

/// Adds a chart with a panel for each scene, if there are any rows.
void add_scenes(Charts& charts, Chart chart, const HierarchyRows& rows) {
    if (rows.empty()) return;
    chart.values["scenes"] = in_words(words_of(rows, &HierarchyRow::scene));
    chart.values["updates"] = in_words(words_of(rows, &HierarchyRow::update));
    for (const HierarchyRow& row : rows) chart.values["particles_" + row.scene] = row.particles;
    charts.push_back(std::move(chart));
}

/// Of the fits of spheres, that by the centroid.
void add_fits(Charts& charts, HierarchyRows rows, bool resampled) {
    std::vector<std::string> drawn = names_in(volume_families, name_of<VolumeKind>);
    drawn.emplace_back("brute");
    std::erase_if(rows, [&](const HierarchyRow& row) {
        return (row.particles == resampled_particles) != resampled || std::ranges::count(drawn, row.variant()) == 0;
    });
    std::vector<std::string> volumes = volumes_in(rows, drawn);
    const bool brute = std::erase(volumes, "brute") > 0;
    add_scenes(
        charts,
        {resampled ? "hierarchy_fit_128" : "hierarchy_fit",
         "hierarchy_fit",
         "CPU time of build, query and exact test of a frame against the cells that are tested in vain, for each "
         "cell that touches the ball. A line joins the leaf sizes of one volume under one update policy; the "
         "nearer to the lower left, the better.",
         {{"resampled", resampled ? 1. : 0.}, {"brute", brute ? 1. : 0.}, {"volumes", in_words(volumes)}}},
        rows);
}

/// The size of a node's volume, 0 for what is none.
std::size_t bytes_of_a_node(const std::string& volume) {
    const auto kind = value_named<VolumeKind>(volume);
    if (!kind || *kind == VolumeKind::Brute) return 0;
    return with_volume(*kind, []<class Volume>(std::type_identity<Volume>) { return sizeof(Volume); });
}

/// What the volumes of a tree take, beside its time a frame: larger cloth, every leaf size, rebuilt.
void add_storage(Charts& charts, const HierarchyRows& rows) {
    std::string data = "scene,volume,bytes,whole_s\n";
    HierarchyRows drawn;
    for (const HierarchyRow& row : rows) {
        const std::size_t bytes = bytes_of_a_node(row.volume);
        const bool wanted = row.particles == resampled_particles && row.variant() == row.volume &&
                            row.update == name_of(UpdateKind::Rebuild) && bytes > 0;
        if (!wanted) continue;
        data += fmt::format("{},{},{:.0f},{:.8g}\n", row.scene, row.volume, row.nodes * static_cast<double>(bytes),
                            row.whole.median);
        drawn.push_back(row);
    }
    std::vector<std::string> bytes;
    for (const std::string& volume : words_of(drawn, &HierarchyRow::volume)) {
        bytes.push_back(fmt::format("{}:{}", volume, bytes_of_a_node(volume)));
    }
    add_scenes(charts,
               {"hierarchy_storage",
                "hierarchy_storage",
                "CPU time of build, query and exact test of a frame against the bytes of the tree's volumes. A line "
                "joins the leaf sizes of one volume, each rebuilt every frame; the legend has the bytes a node.",
                {{"volumes", in_words(bytes)}},
                data},
               drawn);
}

void add_spheres(Charts& charts, HierarchyRows rows) {
    std::erase_if(rows, [](const HierarchyRow& row) {
        return row.particles == resampled_particles || row.volume != "sphere" || row.leaf_cells != 4 ||
               (row.update != "rebuild" && row.update != "merge");
    });
    add_scenes(charts,
               {"hierarchy_spheres",
                "hierarchy_spheres",
                "CPU time of a build against the mean tightness of its spheres. Rebuilding fits every node to its "
                "particles; merging fits the leaves only and puts a sphere about the spheres below every other node.",
                {{"fits", in_words(words_of(rows, &HierarchyRow::sphere_fit))}}},
               rows);
}

void add_level(Charts& charts, const std::string& scene) {
    charts.push_back({"hierarchy_level_" + scene,
                      "hierarchy_level",
                      "What a search knows that ends at a level: how loose the nodes there are, how many of them it "
                      "visits, how many cells it would test in vain for each that touches, and the CPU time it has "
                      "taken to get there.",
                      {{"scene", scene}}});
}

void add_budget(Charts& charts, const HierarchyRows& rows) {
    add_scenes(charts,
               {"hierarchy_budget",
                "hierarchy_budget",
                "How a search that ends early changes the simulated motion: the deepest penetration that is left, "
                "nodes that were taken for contacts although nothing in them touches, and how far the cloth is at the "
                "end from where the full search has it. At the right end of each line the search is full. Penetrations "
                "of less than 0.01 mm are drawn as 0.01 mm.",
                {}},
               rows_with(rows, &HierarchyRow::volume, "sphere"));
}

void add_break_even(Charts& charts, const std::string& scene, const HierarchyRows& rows) {
    const std::vector<std::string> volumes = volumes_in(rows, {"sphere", "aabb"});
    if (volumes.empty()) return;
    // The interval next to the rate of a screen, or what is there in a share of the cases
    const auto nearest =
        std::ranges::min_element(rows, {}, [](const HierarchyRow& row) { return std::abs(row.interval_s - 1.0 / 60); });
    charts.push_back({"hierarchy_break_even_" + scene,
                      "hierarchy_break_even",
                      "Left: CPU time of build, query and exact test of all frames so far, over that of rebuilding; "
                      "where a line crosses 1 is its break-even frame. Middle: how loose the nodes have become. Right: "
                      "the same ratio after the last frame, over the time that the cloth has had to move between "
                      "frames.",
                      {{"scene", scene},
                       {"volumes", in_words(volumes)},
                       {"updates", in_words(words_of(rows, &HierarchyRow::update))},
                       {"interval", nearest->interval_s},
                       {"frames", std::ranges::max(rows, {}, &HierarchyRow::frame).frame}}});
}

void add_size(Charts& charts, const HierarchyRows& rows) {
    std::vector<std::string> builds, searches;
    for (const Growth& growth : growths(rows)) {
        if (growth.update != "rebuild" && growth.update != "merge") continue;
        const std::string hierarchy = growth.volume + ":" + growth.update + ":";
        searches.push_back(hierarchy + fmt::format("{:.2f}", growth.search));
        if (growth.volume != "brute") builds.push_back(hierarchy + fmt::format("{:.2f}", growth.build));
    }
    if (searches.empty()) return;
    charts.push_back({"hierarchy_size",
                      "hierarchy_size",
                      "CPU time of a build and of a search, medians with quartiles, on one motion under more and more "
                      "particles; the exponents are fitted to the larger half of the sizes.",
                      {{"builds", in_words(builds)}, {"searches", in_words(searches)}}});
}

}  // namespace

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
        all.push_back({key.first, key.second, fitted_exponent(build), fitted_exponent(search)});
    }
    return all;
}

std::vector<Chart> hierarchy_charts(const std::vector<HierarchyRow>& rows) {
    const auto part = [&rows](const char* name) { return rows_with(rows, &HierarchyRow::part, name); };
    Charts charts;
    for (const bool resampled : {false, true}) add_fits(charts, part("fit"), resampled);
    add_storage(charts, part("fit"));
    add_spheres(charts, part("fit"));
    for (const std::string& scene : words_of(part("level"), &HierarchyRow::scene)) add_level(charts, scene);
    add_budget(charts, part("budget"));
    for (const std::string& scene : words_of(part("break_even"), &HierarchyRow::scene)) {
        add_break_even(charts, scene, rows_with(part("break_even"), &HierarchyRow::scene, scene));
    }
    add_size(charts, part("size"));
    return charts;
}

}  // namespace drape
