#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "drape/base/exact_math.h"
#include "drape/bounds/node_view.h"
#include "hierarchy.h"
#include "lab/experiments.h"

namespace drape {
namespace {

using Charts = std::vector<Chart>;

/// Those of some volumes that rows have.
std::vector<std::string> volumes_in(const Rows& rows, std::vector<std::string> volumes) {
    std::erase_if(volumes, [&rows](const std::string& volume) {
        return std::ranges::find(rows, volume, word_of("volume")) == rows.end();
    });
    return volumes;
}

/// Name of the volume, with the fit of a sphere that is not by the centroid.
std::string variant_of(const Row& row) {
    const bool plain = row.word("volume") != "sphere" || row.word("sphere_fit") == name_of(SphereFit::Centroid);
    return plain ? row.word("volume") : row.word("volume") + " " + row.word("sphere_fit");
}

bool is_resampled(const Row& row) { return row.number("particles") == resampled_particles; }

/// Adds a chart with a panel for each scene, if there are any rows.
void add_scenes(Charts& charts, Chart chart, const Rows& rows) {
    if (rows.empty()) return;
    chart.values["scenes"] = in_words(words_of(rows, "scene"));
    chart.values["updates"] = in_words(words_of(rows, "update"));
    for (const Row& row : rows) chart.values["particles_" + row.word("scene")] = row.number("particles");
    charts.push_back(std::move(chart));
}

/// Of the fits of spheres, that by the centroid.
void add_fits(Charts& charts, Rows rows, bool resampled) {
    std::vector<std::string> drawn = names_in(volume_families, name_of<VolumeKind>);
    drawn.emplace_back("brute");
    std::erase_if(rows, [&](const Row& row) {
        return is_resampled(row) != resampled || std::ranges::count(drawn, variant_of(row)) == 0;
    });
    std::vector<std::string> volumes = volumes_in(rows, drawn);
    const bool brute = std::erase(volumes, "brute") > 0;
    add_scenes(
        charts,
        {resampled ? "hierarchy_fit_128" : "hierarchy_fit",
         "CPU time of build, query and exact test of a frame against the cells that are tested in vain, for each "
         "cell that touches the ball. A line joins the leaf sizes of one volume, rebuilt, or merged where that is the "
         "fastest; the nearer to the lower left, the better.",
         {{"resampled", resampled ? 1. : 0.}, {"brute", brute ? 1. : 0.}, {"volumes", in_words(volumes)}},
         {},
         "hierarchy_fit"},
        rows);
}

/// The size of a node's volume, 0 for what is none.
std::size_t bytes_of_a_node(const std::string& volume) {
    const auto kind = value_named<VolumeKind>(volume);
    if (!kind || *kind == VolumeKind::Brute) return 0;
    return with_volume(*kind, []<class Volume>(std::type_identity<Volume>) { return sizeof(Volume); });
}

/// What the volumes of a tree take, beside its time a frame: larger cloth, every leaf size, rebuilt.
void add_storage(Charts& charts, const Rows& rows) {
    std::string data = "scene,volume,bytes,whole_s\n";
    Rows drawn;
    for (const Row& row : rows) {
        const std::string volume = row.word("volume");
        const std::size_t bytes = bytes_of_a_node(volume);
        const bool wanted =
            is_resampled(row) && variant_of(row) == volume && row.word("update") == "rebuild" && bytes > 0;
        if (!wanted) continue;
        data += fmt::format("{},{},{:.0f},{:.8g}\n", row.word("scene"), volume,
                            row.number("nodes") * static_cast<double>(bytes), row.number("whole_s"));
        drawn.push_back(row);
    }
    std::vector<std::string> bytes;
    for (const std::string& volume : words_of(drawn, "volume")) {
        bytes.push_back(fmt::format("{}:{}", volume, bytes_of_a_node(volume)));
    }
    add_scenes(charts,
               {"hierarchy_storage",
                "CPU time of build, query and exact test of a frame against the bytes of the tree's volumes. A line "
                "joins the leaf sizes of one volume, each rebuilt every frame; beside it the bytes a node.",
                {{"volumes", in_words(bytes)}},
                data},
               drawn);
}

void add_spheres(Charts& charts, Rows rows) {
    std::erase_if(rows, [](const Row& row) {
        return is_resampled(row) || row.word("volume") != "sphere" || row.number("leaf_cells") != 4 ||
               (row.word("update") != "rebuild" && row.word("update") != "merge");
    });
    add_scenes(charts,
               {"hierarchy_spheres",
                "CPU time of a build against the mean tightness of its spheres. Rebuilding fits every node to its "
                "particles; merging fits the leaves only and puts a sphere about the spheres below every other node.",
                {{"fits", in_words(words_of(rows, "sphere_fit"))}}},
               rows);
}

Charts fit_charts(const Rows& rows) {
    Charts charts;
    for (const bool resampled : {false, true}) add_fits(charts, rows, resampled);
    add_storage(charts, rows);
    add_spheres(charts, rows);
    return charts;
}

Charts level_charts(const Rows& rows) {
    Charts charts;
    for (const std::string& scene : words_of(rows, "scene")) {
        charts.push_back(
            {"hierarchy_level_" + scene,
             "What a search knows that ends at a level: how loose the nodes there are, how many of them it "
             "visits, how many cells it would test in vain for each that touches, and the CPU time it has "
             "taken to get there.",
             {{"scene", scene}},
             {},
             "hierarchy_level"});
    }
    return charts;
}

Charts missed_charts(const Rows& rows) {
    Charts charts;
    add_scenes(charts,
               {"hierarchy_budget",
                "How a search that ends early changes the simulated motion: the deepest penetration that is left, "
                "nodes that were taken for contacts although nothing in them touches, and how far the cloth is at the "
                "end from where the full search has it. At the right end of each line the search is full. Penetrations "
                "of less than 0.01 mm are drawn as 0.01 mm.",
                {}},
               rows_with(rows, "volume", "sphere"));
    return charts;
}

void add_break_even(Charts& charts, const std::string& scene, const Rows& rows) {
    const std::vector<std::string> volumes = volumes_in(rows, {"sphere", "aabb"});
    if (volumes.empty()) return;
    // The interval next to the rate of a screen, or what is there in a share of the cases
    const auto off = [](const Row& row) { return std::abs(row.number("interval_s") - 1.0 / 60); };
    const double interval = std::ranges::min(rows, {}, off).number("interval_s");
    charts.push_back(
        {"hierarchy_break_even_" + scene,
         "Left: CPU time of build, query and exact test of all frames so far, over that of rebuilding; "
         "where a line crosses 1 is its break-even frame. Right: the same ratio after the last frame, over "
         "the time that the cloth has had to move between frames, and how loose a tree is that is kept.",
         {{"scene", scene},
          {"volumes", in_words(volumes)},
          {"updates", in_words(words_of(rows, "update"))},
          {"interval", interval},
          {"frames", std::ranges::max(rows, {}, number_of("frame")).number("frame")}},
         {},
         "hierarchy_break_even"});
}

Charts break_even_charts(const Rows& rows) {
    Charts charts;
    for (const std::string& scene : words_of(rows, "scene")) {
        add_break_even(charts, scene, rows_with(rows, "scene", scene));
    }
    return charts;
}

Charts growth_charts(const Rows& rows) {
    std::vector<std::string> builds, searches;
    for (const Growth& growth : growths(rows)) {
        if (growth.update != "rebuild" && growth.update != "merge") continue;
        const std::string hierarchy = growth.volume + ":" + growth.update + ":";
        searches.push_back(hierarchy + fmt::format("{:.2f}", growth.search));
        if (growth.volume != "brute") builds.push_back(hierarchy + fmt::format("{:.2f}", growth.build));
    }
    if (searches.empty()) return {};
    return {{"hierarchy_size",
             "CPU time of a build and of a search, medians, on one motion under more and more "
             "particles; the exponents are fitted to the larger half of the sizes.",
             {{"builds", in_words(builds)}, {"searches", in_words(searches)}}}};
}

}  // namespace

std::vector<Growth> growths(const Rows& rows) {
    if (rows.empty()) return {};
    const auto particles = number_of("particles");
    const auto [least, most] = std::ranges::minmax(rows, {}, particles);
    const double from = std::sqrt(particles(least) * particles(most)) * (1 - 1e-9);
    Rows large = rows;
    std::erase_if(large, [&](const Row& row) { return particles(row) < from; });
    const auto hierarchy = [](const Row& row) { return std::pair(row.word("volume"), row.word("update")); };
    std::vector<Growth> all;
    for (const auto& [key, sizes] : groups_of(large, hierarchy)) {
        std::set<double> logarithms;
        std::vector<std::pair<double, double>> build, search;
        for (const Row& row : sizes) {
            logarithms.insert(natural_log(particles(row)));
            // Brute force builds nothing: a time of zero is no power law
            build.emplace_back(particles(row), std::max(row.number("build_s"), 1e-9));
            search.emplace_back(particles(row), row.number("query_s") + row.number("exact_s"));
        }
        if (logarithms.size() < 2) continue;
        all.push_back({key.first, key.second, fitted_exponent(build), fitted_exponent(search)});
    }
    return all;
}

Experiment hierarchy_experiment() {
    const auto motions = std::make_shared<Motions>();
    const auto with_motions = [motions](const auto& cases) {
        return [motions, cases](bool quick) { return cases(quick, motions); };
    };
    return {"hierarchy",
            "what does a tighter hierarchy cost, and what does it save?",
            8,
            {word_column("part", {"fit", "level", "budget", "break_even", "size"}),
             word_column("scene", names_in(hierarchy_scenes, &HierarchyScene::name)), name_column<VolumeKind>("volume"),
             name_column<SphereFit>("sphere_fit", {"none"}), name_column<UpdateKind>("update"),
             whole_column("particles", 4),
             whole_column("leaf_cells"),      // 0: as measured to be fastest
             whole_column("level").or_nan(),  // that the row is about, or at which the search ended
             whole_column("tests").or_nan(),  // after which the search ended
             number_column("interval_s"),     // between frames
             whole_column("frame").or_nan(),
             // CPU times, over frames and repeats
             number_column("build_s").or_nan().with_quartiles(), number_column("query_s").or_nan().with_quartiles(),
             number_column("exact_s").or_nan().with_quartiles(),
             number_column("whole_s"),  // build, query and exact test
             number_column("whole_lower_s").or_nan(), number_column("whole_upper_s").or_nan(),
             number_column("cumulative_s").or_nan(),  // of all frames so far, medians over repeats
             number_column("cumulative_s_over_rebuild_s").or_nan(),
             // A mean frame; the same in every run
             number_column("nodes"),                    // of the whole tree, or of the level
             number_column("visited"),                  // by the search
             number_column("candidates"),               // cells
             number_column("touching"),                 // cells
             number_column("false_per_true").or_nan(),  // candidates that do not touch over those that do
             number_column("tightness").or_nan(),  // mean size of nodes, over that of the smallest volume of the kind
             number_column("moved").or_nan(),      // part of the particles that moved farther than a refit lets pass
             // What a limited search did to the simulated motion
             number_column("missed_penetration_m").or_nan(),  // largest
             number_column("false_contacts").or_nan(),        // a step
             number_column("distance_m").or_nan()},  // RMS of the particles from those of the full search, at the end
            {{"part", "scene", "particles", "volume"},
             {"whole_s", "false_per_true", "tightness", "missed_penetration_m", "cumulative_s_over_rebuild_s"}},
            {{"fit", with_motions(hierarchy_fits), fit_charts},
             {"level", with_motions(hierarchy_levels), level_charts},
             {"budget", with_motions(hierarchy_budgets), missed_charts},
             {"break_even", with_motions(hierarchy_break_evens), break_even_charts},
             {"size", with_motions(hierarchy_sizes), growth_charts}}};
}

}  // namespace drape
