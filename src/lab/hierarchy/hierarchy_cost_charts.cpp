#include <algorithm>
#include <cmath>

#include "drape/base/numbers.h"
#include "hierarchy_charts.h"
#include "hierarchy_summary.h"
#include "lab/experiment/chart_text.h"

namespace drape {

Chart budget_chart(const ChartTable& table, const std::vector<HierarchyRow>& rows) {
    constexpr std::pair<const char*, int> styles[] = {{"#0072B2", 7}, {"#D55E00", 5}, {"#009E73", 9}};
    std::string text =
        begin_panels("1,3", "A search that ends after a number of volume tests (spheres, leaves of 4 x 4 cells)",
                     "0.06,0.985,0.235,0.88 spacing 0.065,0", 0.065) +
        "set logscale x\nset xlabel 'volume tests allowed, or made, in a frame'\n";
    const auto add = [&](const std::string& label, const std::string& y) {
        Panel panel(table);
        std::size_t k = 0;
        for (const std::string& scene : scenes_of(rows)) {
            const auto& [colour, type] = styles[k++ % std::size(styles)];
            const std::string& name = readable(scene);
            const Picked picked{{{"part", "budget"}, {"scene", scene}, {"volume", "sphere"}}, {}};
            panel.draw(
                picked, {column("tests"), y},
                "linespoints lw 1.5 pt " + std::to_string(type) + " " + coloured(colour) + " title " + in_quotes(name));
            panel.draw(picked, {"(column('level') >= 0 ? " + column("visited") + " : NaN)", y},
                       "points ps 1.4 lw 1.5 pt " + std::to_string(type - 1) + " " + coloured(colour) + " title " +
                           in_quotes(name + ", ended at a level"));
        }
        text += "set ylabel '" + label + "'\n" + panel.plot() + "unset key\n";
    };
    // On a scale that has no zero: what is less than a hundredth of a millimetre is drawn there
    const std::string missed = column("missed_penetration_m", "1e3");
    text += "set logscale y\n";
    add("largest missed penetration [mm]", "(" + missed + " > 0.01 ? " + missed + " : 0.01)");
    text += "unset logscale y\n";
    add("false contacts a step", column("false_contacts"));
    add("RMS distance at the end [mm]", column("distance_m", "1e3"));
    return {"hierarchy_budget", 1280, 520, text + end_panels(),
            "What the simulated motion loses by a search that ends early: the deepest penetration that is left, nodes "
            "that were taken for contacts although nothing in them touches, and how far the cloth is at the end from "
            "where the full search has it. At the right end of each line the search is full. Penetrations of less than "
            "0.01 mm are drawn as 0.01 mm."};
}

Chart break_even_chart(const ChartTable& table, const std::vector<HierarchyRow>& rows, const std::string& scene) {
    // The interval next to the rate of a screen, or what is there in a share of the cases
    double interval = rows.front().interval_s, last = 0;
    for (const HierarchyRow& row : rows) {
        if (row.scene != scene) continue;
        if (std::abs(row.interval_s - 1.0 / 60) < std::abs(interval - 1.0 / 60)) interval = row.interval_s;
        last = std::max(last, row.frame);
    }
    std::string text = begin_panels("2,3", "What the updates cost in all: " + readable(scene) + ", 64 x 64 particles",
                                    "0.07,0.985,0.155,0.91 spacing 0.075,0.15", 0.04);
    for (const std::string volume : {"sphere", "aabb"}) {
        const auto add = [&](const std::vector<std::string>& columns, const std::pair<std::string, double>& at,
                             const std::string& style) {
            Panel panel(table);
            for (const UpdateStyle& update : update_styles) {
                panel.draw(
                    {{{"part", "break_even"}, {"scene", scene}, {"volume", volume}, {"update", update.update}}, {at}},
                    columns,
                    "linespoints lw 1.5 pt " + std::to_string(update.marker) + " " + style + " " +
                        coloured(update.colour) + " title " + in_quotes(update.update));
            }
            text += panel.plot() + "unset key\n";
        };
        const std::string ratio = column("cumulative_s_over_rebuild_s");
        text += "unset logscale\nset title '" + volume + ", frames " + real_text(1e3 * interval, 3) +
                " ms apart'\nset xlabel 'frame'\nset ylabel 'cost so far over that of rebuild'\nset yrange [0:*]\n";
        add({column("frame"), ratio}, {"interval_s", interval}, "ps 0.6 pi 5");
        text += "set ylabel 'size over the smallest of its kind'\nset logscale y\nset yrange [*:*]\n";
        add({column("frame"), column("tightness")}, {"interval_s", interval}, "ps 0.6");
        text += "set title '" + volume + ", after " + real_text(last) +
                " frames'\nset logscale x\nunset logscale y\nset yrange [0:*]\nset xlabel 'time between frames [ms]'\n"
                "set ylabel 'cost over that of rebuild'\n";
        add({column("interval_s", "1e3"), ratio}, {"frame", last}, "ps 0.9");
    }
    return {"hierarchy_break_even_" + scene, 1280, 800, text + end_panels(),
            "Left: CPU time of build, query and exact test of all frames so far, over that of rebuilding; where a "
            "line crosses 1 is its break-even frame. Middle: how loose the nodes have become. Right: the same "
            "ratio after the last frame, over the time that the cloth has had to move between frames."};
}

Chart size_chart(const ChartTable& table, const std::vector<HierarchyRow>& rows) {
    std::string text = begin_panels("1,2", "Cost against the number of particles, leaves as measured to be fastest",
                                    "0.075,0.985,0.11,0.9 spacing 0.08,0", 0.03) +
                       "set logscale xy\nset format '10^{%L}'\nset xlabel 'particles'\n"
                       "set key default top left Left reverse samplen 2\n"
                       "set offsets graph 0.05, graph 0.05, graph 0.45, graph 0.05\n";
    const auto add = [&](const std::string& label, std::vector<std::string> columns, bool build) {
        columns.insert(columns.begin(), column("particles"));
        Panel panel(table);
        for (const Growth& growth : growths(rows)) {
            const auto volume = std::ranges::find(volume_styles, growth.volume, &VolumeStyle::volume);
            const bool brute = volume == volume_styles.end();
            if ((brute && build) || growth.update == "refit" || growth.update == "none") continue;
            const double exponent = (build ? growth.build : growth.search).exponent;
            panel.draw({{{"part", "size"}, {"volume", growth.volume}, {"update", growth.update}}, {}}, columns,
                       "yerrorlines lw 1.3 ps 0.8 " +
                           std::string(growth.update == "merge" ? "dt 2 pt 4 " : "dt 1 pt 7 ") +
                           coloured(brute ? "#000000" : volume->colour) + " title " +
                           in_quotes((brute ? "brute force" : growth.volume + " " + growth.update) + ": n^{" +
                                     real_text(std::round(100 * exponent) / 100) + "}"));
        }
        text += "set ylabel '" + label + "'\n" + panel.plot();
    };
    const auto us = [](const std::string& name) { return column(name, "1e6"); };
    add("build [us]", {us("build_s"), us("build_lower_s"), us("build_upper_s")}, true);
    add("query + exact test [us]",
        {us("query_s") + "+" + us("exact_s"), us("query_lower_s") + "+" + us("exact_lower_s"),
         us("query_upper_s") + "+" + us("exact_upper_s")},
        false);
    return {"hierarchy_size", 1200, 620, text + end_panels(),
            "CPU time of a build and of a search, medians with quartiles, on one motion under more and more "
            "particles; the exponents are fitted to the larger half of the sizes."};
}

}  // namespace drape
