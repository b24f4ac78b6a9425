#include <algorithm>

#include "hierarchy_charts.h"
#include "hierarchy_parts.h"
#include "lab/experiment/chart_text.h"

namespace drape {
namespace {

/// The number of particles that a scene's motion was followed with, as it is or resampled; 0 if it was not.
double particles_of(const std::vector<HierarchyRow>& rows, const std::string& scene, bool resampled) {
    const auto row = std::ranges::find_if(rows, [&](const HierarchyRow& each) {
        return each.scene == scene && (each.particles == resampled_particles) == resampled;
    });
    return row == rows.end() ? 0 : row->particles;
}

std::string marker(int type) { return "points pt " + std::to_string(type); }

/// A line of the levels' chart.
struct LevelLine {
    const char* volume;
    const char* fit;
    const char* update;
    const char* style;
};

}  // namespace

Chart fit_chart(const ChartTable& table, const std::vector<HierarchyRow>& rows, bool resampled) {
    const std::vector<std::string> scenes = scenes_of(rows);
    std::string text = begin_panels("1," + std::to_string(scenes.size()),
                                    std::string("Time of a frame against accuracy, ") +
                                        (resampled ? "scenes resampled to 128 x 128 particles" : "scenes as they are"),
                                    "0.07,0.985,0.22,0.87 spacing 0.05,0", 0.065) +
                       "set logscale xy\nset xtics (0.1, 0.3, 1, 3, 10, 30, 100, 300, 1000)\n"
                       "set ytics (1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10000)\n"
                       "set xlabel 'false candidates per true one'\nset ylabel 'build + query + exact test [us]'\n";
    const std::vector<std::string> axes{column("false_per_true"), column("whole_s", "1e6")};
    for (const std::string& scene : scenes) {
        Panel panel(table);
        const auto picked = [&](const std::string& volume, const std::string& fit, const std::string& update) {
            return Picked{
                {{"part", "fit"}, {"scene", scene}, {"volume", volume}, {"sphere_fit", fit}, {"update", update}},
                {{"particles", particles_of(rows, scene, resampled)}}};
        };
        for (const VolumeStyle& volume : volume_styles) {
            for (const UpdateStyle& update : update_styles) {
                panel.draw(picked(volume.volume, volume.fit, update.update), axes,
                           "linespoints lw 1 pt " + std::to_string(update.marker) + " ps 0.8 " +
                               coloured(volume.colour) + " notitle");
            }
        }
        panel.draw(picked("brute", "none", "rebuild"), axes,
                   "points pt 3 ps 1.5 lw 2 lc rgb 'black' title 'brute force'");
        for (const VolumeStyle& volume : volume_styles) {
            panel.entry("lines lw 4 " + coloured(volume.colour), volume.volume);
        }
        for (const UpdateStyle& update : update_styles) {
            panel.entry(marker(update.marker) + " lc rgb '#555555'", update.update);
        }
        text += "set title " + in_quotes(readable(scene)) + "\n" + panel.plot() + "unset key\nset ylabel ''\n";
    }
    return {resampled ? "hierarchy_fit_128" : "hierarchy_fit", 1280, 560, text + end_panels(),
            "CPU time of build, query and exact test of a frame against the cells that are tested in vain, for each "
            "cell that touches the ball. A line joins the leaf sizes of one volume under one update; the nearer to "
            "the lower left, the better."};
}

Chart sphere_chart(const ChartTable& table, const std::vector<HierarchyRow>& rows) {
    const std::vector<std::string> scenes = scenes_of(rows);
    constexpr std::pair<const char*, const char*> fits[] = {
        {"centroid", "#0072B2"}, {"box", "#56B4E9"},    {"ritter", "#D55E00"}, {"epos6", "#E69F00"},
        {"epos14", "#009E73"},   {"epos26", "#CC79A7"}, {"welzl", "#000000"}};
    constexpr std::pair<const char*, int> updates[] = {{"rebuild", 7}, {"merge", 5}};
    std::string text = begin_panels("1," + std::to_string(scenes.size()), "Sphere fits, leaves of at most 4 x 4 cells",
                                    "0.07,0.985,0.235,0.86 spacing 0.05,0", 0.065) +
                       "set logscale y\nset ytics (1, 2, 5, 10, 20, 50, 100, 200, 500)\nset xtics 0.01\n"
                       "set xlabel 'mean radius over that of the smallest sphere'\nset ylabel 'build [us]'\n";
    for (const std::string& scene : scenes) {
        Panel panel(table);
        for (const auto& [fit, colour] : fits) {
            bool drawn = false;
            for (const auto& [update, type] : updates) {
                const Picked picked{{{"part", "fit"}, {"scene", scene}, {"sphere_fit", fit}, {"update", update}},
                                    {{"leaf_cells", 4}, {"particles", particles_of(rows, scene, false)}}};
                panel.draw(picked, {column("tightness"), column("build_s", "1e6")},
                           marker(type) + " ps 1.3 " + coloured(colour) + " notitle");
                drawn = drawn || table.has(picked);
            }
            if (drawn) panel.entry("lines lw 4 " + coloured(colour), fit);
        }
        for (const auto& [update, type] : updates) panel.entry(marker(type) + " lc rgb '#555555'", update);
        text += "set title " + in_quotes(readable(scene)) + "\n" + panel.plot() + "unset key\nset ylabel ''\n";
    }
    return {"hierarchy_spheres", 1280, 520, text + end_panels(),
            "CPU time of a build against the mean tightness of its spheres. Rebuilding fits every node to its "
            "particles; merging fits the leaves only and puts a sphere about the spheres below every other node."};
}

Chart level_chart(const ChartTable& table, const std::string& scene) {
    constexpr LevelLine lines[] = {
        {"sphere", "centroid", "rebuild", "pt 7 dt 1 lc rgb '#0072B2' title 'sphere, rebuilt'"},
        {"sphere", "centroid", "merge", "pt 6 dt 2 lc rgb '#56B4E9' title 'sphere, merged'"},
        {"sphere", "welzl", "rebuild", "pt 4 dt 3 lc rgb '#000000' title 'smallest sphere'"},
        {"aabb", "none", "rebuild", "pt 5 dt 1 lc rgb '#D55E00' title 'aabb'"},
        {"kdop18", "none", "rebuild", "pt 9 dt 1 lc rgb '#009E73' title 'kdop18'"},
        {"obb", "none", "rebuild", "pt 13 dt 1 lc rgb '#CC79A7' title 'obb'"}};
    std::string text = begin_panels("2,2", "Level by level: " + readable(scene) + ", leaves of one cell",
                                    "0.08,0.98,0.165,0.93 spacing 0.09,0.1", 0.045) +
                       "set xtics 1\n";
    const auto add = [&](const std::string& label, const std::string& y) {
        Panel panel(table);
        for (const LevelLine& line : lines) {
            panel.draw({{{"part", "level"},
                         {"scene", scene},
                         {"volume", line.volume},
                         {"sphere_fit", line.fit},
                         {"update", line.update}},
                        {}},
                       {column("level"), y}, "linespoints lw 1.5 ps 0.9 " + std::string(line.style));
        }
        text += "set ylabel '" + label + "'\n" + panel.plot() + "unset key\nset logscale y\n";
    };
    add("size over the smallest of its kind", column("tightness"));
    add("nodes visited at the level", column("visited"));
    text += "set xlabel 'level (0 is the root)'\n";
    add("false candidates per true one", column("false_per_true"));
    add("query down to the level [us]", column("query_s", "1e6"));
    return {"hierarchy_level_" + scene, 1100, 760, text + end_panels(),
            "What a search knows that ends at a level: how loose the nodes there are, how many of them it visits, how "
            "many cells it would test in vain for each that touches, and the CPU time it has taken to get there."};
}

}  // namespace drape
