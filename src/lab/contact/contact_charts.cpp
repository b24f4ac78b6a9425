#include <algorithm>

#include "contact_experiment.h"
#include "drape/base/numbers.h"
#include "lab/experiment/chart_text.h"

namespace drape {
namespace {

namespace at = contact_column;

/// A speed of the ball as it is drawn, in one of Okabe and Ito's colours.
struct SpeedStyle {
    double speed;
    const char* colour;
    int marker;
};
constexpr SpeedStyle speeds[] = {{0.5, "#CC79A7", 13}, {2, "#0072B2", 7}, {8, "#009E73", 5}, {32, "#D55E00", 9}};

}  // namespace

std::vector<Chart> contact_charts(const std::vector<TableRow>& rows) {
    if (rows.empty()) return {};
    const ChartTable table(contact_experiment().columns, rows);
    std::vector<std::string> searches;  // by their tests
    for (const TableRow& row : rows) {
        if (std::ranges::find(searches, row[at::Tests]) == searches.end()) searches.push_back(row[at::Tests]);
    }
    std::string text = begin_panels("2," + std::to_string(searches.size()),
                                    "Accuracy of contact: a ball on its way through a hung cloth",
                                    "0.07,0.985,0.165,0.9 spacing 0.04,0.06", 0.035) +
                       "set logscale x\nset xtics (0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5)\nset offsets graph 0.05, graph "
                       "0.05, 0, 0\nset yrange [-4:104]\n";
    const std::string cost = column("cpu_s_per_s");
    const auto add = [&](const std::string& y, const std::string& label, bool titled) {
        text += "set ylabel '" + label + "'\n";
        for (const std::string& tests : searches) {
            Panel panel(table);
            for (const SpeedStyle& style : speeds) {
                Picked picked{{{"tests", tests}}, {{"speed_m_per_s", style.speed}}};
                panel.draw(picked, {cost, y},
                           "linespoints lw 1.5 pt " + std::to_string(style.marker) + " ps 0.8 " +
                               coloured(style.colour) + " title " +
                               in_quotes("ball at " + real_text(style.speed) + " m/s"));
                picked.numbers.emplace_back("passed", 1);
                panel.draw(picked, {cost, y}, "points pt 6 ps 2 lw 1.5 lc rgb 'black' notitle");
            }
            panel.entry("points pt 6 ps 1.6 lw 1.5 lc rgb 'black'", "the ball has gone through");
            const std::string title = tests == "0" ? "full search" : "search ends after " + tests + " tests";
            if (titled) text += "set title " + in_quotes(title) + "\n";
            text += panel.plot() + "unset key\nset ylabel ''\n";
        }
        text += "unset title\n";
    };
    add(column("missed_contacts", "100"), "missed contacts [%]", true);
    // On a scale that has no zero: what is less than a millimetre is drawn there
    const std::string depth = column("penetration_m", "1e3");
    text += "set xlabel 'CPU time for a simulated second [s]'\nset logscale y\nset yrange [0.8:250]\n";
    add("(" + depth + " > 1 ? " + depth + " : 1)", "worst penetration [mm]", false);
    return {
        {"contact", 1280, 760, text + end_panels(),
         "Contacts that the reference has and a run does not, step by step, and the deepest that the ball is in the "
         "cloth when a step finds it, against CPU time: the points of a line are steps, the longest on the left. A "
         "ball that has gone through counts with its radius, a penetration below 1 mm as that. The reference is the "
         "full search at a step a hundred times smaller."}};
}

}  // namespace drape
