#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "drape/base/input_error.h"
#include "drape/base/numbers.h"
#include "lab/experiment/chart_text.h"
#include "precision_diagram.h"
#include "precision_experiment.h"
#include "reference.h"

namespace drape {
namespace {

/// A marker a method, a colour a variant, dashes where the Hessian is clamped.
const std::string& style_of(const std::string& method) {
    static const std::map<std::string, std::string> styles{{"explicit_euler", "pt 2 lc rgb '#D55E00'"},
                                                           {"symplectic_euler", "pt 7 lc rgb '#E69F00'"},
                                                           {"velocity_verlet", "pt 5 lc rgb '#0072B2'"},
                                                           {"rk4", "pt 9 lc rgb '#009E73'"},
                                                           {"dormand_prince", "pt 13 lc rgb 'black'"},
                                                           {"backward_euler", "pt 11 lc rgb '#D55E00'"},
                                                           {"implicit_midpoint_clamped", "pt 14 dt 2 lc rgb '#56B4E9'"},
                                                           {"implicit_midpoint_exact", "pt 15 lc rgb '#0072B2'"},
                                                           {"bdf2_clamped", "pt 3 dt 2 lc rgb '#CC79A7'"},
                                                           {"bdf2_exact", "pt 3 lc rgb 'black'"},
                                                           {"xpbd_1", "pt 1 lc rgb '#E69F00'"},
                                                           {"xpbd_5", "pt 1 lc rgb '#D55E00'"},
                                                           {"xpbd_20", "pt 1 lc rgb 'black'"},
                                                           {"projective_dynamics_5", "pt 6 lc rgb '#56B4E9'"},
                                                           {"projective_dynamics_20", "pt 6 lc rgb '#0072B2'"}};
    return styles.at(method);
}

constexpr std::array<const char*, 3> panel_titles{"explicit", "implicit", "positional"};
constexpr const char* front_style = "lw 6 lc rgb '#d0d0d0'";
constexpr const char* line_style = "ps 0.9 lw 1.5 ";

/// Whole powers of ten about some numbers, as gnuplot writes a range.
std::string decades(double least, double most) {
    const auto power = [](double exponent) { return "1e" + std::to_string(static_cast<int>(exponent)); };
    return "[" + power(std::floor(std::log10(least))) + ":" + power(std::ceil(std::log10(most))) + "]";
}

std::string ranges(const PrecisionDiagram& diagram) {
    std::vector<double> errors, costs;
    for (const PrecisionCurve& curve : diagram.curves) {
        for (const PrecisionPoint& point : curve.points) {
            errors.push_back(point.error);
            costs.push_back(point.cost);
        }
    }
    const auto [least_error, most_error] = std::ranges::minmax(errors);
    const auto [least_cost, most_cost] = std::ranges::minmax(costs);
    return "set xrange " + decades(least_error, most_error) + "\nset yrange " + decades(least_cost, most_cost) + "\n";
}

/// The curves of one panel over the front.
std::string panel(const PrecisionDiagram& diagram, std::size_t number) {
    std::string text = "set title '" + std::string(panel_titles[number]) +
                       "' offset 0,-0.5\nplot $front using 1:2 with "
                       "lines " +
                       front_style + " notitle";
    for (const PrecisionCurve& curve : diagram.curves) {
        if (static_cast<std::size_t>(curve.method.panel) != number || curve.points.empty()) continue;
        const std::string data = ", \\\n     table using (strcol('scene') eq " + in_quotes(diagram.scene) +
                                 " && strcol('method') eq " + in_quotes(curve.method.name) +
                                 " && strcol('end') eq 'bounded' ? column('error') : NaN):(column('cost_s_per_s'))";
        text += data + ":(column('cost_lower_s_per_s')):(column('cost_upper_s_per_s')) with yerrorlines " + line_style +
                style_of(curve.method.name) + " notitle";
    }
    return text + "\n";
}

/// The key, where a fourth panel would be, with the order of each curve.
std::string key(const PrecisionDiagram& diagram) {
    std::string text =
        "unset title\nunset border\nunset tics\nunset xlabel\nunset ylabel\nunset logscale\nunset grid\n"
        "set key at screen 0.53,0.475 left top Left reverse maxrows 20 samplen 3 spacing 1.1\n"
        "plot [0:1][0:1] 2 "
        "notitle, \\\n"
        "     keyentry with lines " +
        std::string(front_style) + " title 'nothing is both more exact and cheaper'";
    int panel = -1;
    for (const PrecisionCurve& curve : diagram.curves) {
        if (curve.method.panel != std::exchange(panel, curve.method.panel)) {
            text += ", \\\n     keyentry with lines lc rgb 'white' title " +
                    in_quotes(std::string(panel_titles[static_cast<std::size_t>(panel)]) + ":");
        }
        text += ", \\\n     keyentry with linespoints " + std::string(line_style) + style_of(curve.method.name) +
                " title " +
                in_quotes(curve.method.title +
                          (curve.order ? ": order " + real_text(curve.order->order, 2) : std::string(": no order")));
    }
    return text + "\n";
}

std::string title_of(const PrecisionDiagram& diagram) {
    const std::string what = diagram.scene == "contact" ? "A sheet falls on a ball" : "A sheet swings from two corners";
    const std::string side = real_text(diagram.particles);
    return what + ": " + side + " x " + side + " particles, " + real_text(diagram.stiffness) + " N/m, to " +
           real_text(diagram.horizon) + " s";
}

std::string caption_of(const PrecisionDiagram& diagram) {
    std::string text =
        "Error at the horizon against the CPU time of a simulated second (medians, quartiles as bars) over a "
        "ladder of steps: left is more exact, down is cheaper. The order is fitted to the finest points.";
    if (diagram.phases != 1) {
        text += " Errors are averaged over " + real_text(diagram.phases) +
                " places of the first impact within a step; from that impact on, every method is of order 1.";
    }
    return text + " The reference is in error by " + real_text(diagram.reference_error, 2) + "; an error of " +
           real_text(small_error, 1) + " m at the start grows " + real_text(diagram.growth, 2) + " times.";
}

Chart chart(const PrecisionDiagram& diagram) {
    const bool positions = diagram.measure == name_of(Measure::Position);
    std::string front = "$front << END\nerror,cost\n";
    for (const PrecisionPoint& point : diagram.front) {
        front += real_text(point.error, 6) + "," + real_text(point.cost, 6) + "\n";
    }
    std::string plot =
        front + "END\nset multiplot layout 2,2 title " + in_quotes(title_of(diagram)) +
        " font ',13'\nset logscale xy\nset format '10^{%L}'\nset grid xtics ytics lt 1 lc rgb '#e0e0e0'\n" +
        "unset key\nset xlabel '" +
        (positions ? "RMS position error over the side of the cloth" : "error of sag, centre of mass and energy") +
        "'\nset ylabel 'CPU seconds a simulated second'\n" + ranges(diagram);
    for (std::size_t number = 0; number < panel_titles.size(); ++number) plot += panel(diagram, number);
    return {"precision_" + diagram.scene, 1060, 860,
            plot + key(diagram) + "unset multiplot\nreset\nset datafile separator ','\nset datafile columnheaders\n",
            caption_of(diagram)};
}

}  // namespace

std::vector<Chart> precision_charts(const std::vector<TableRow>& rows) {
    std::vector<Chart> charts;
    for (const PrecisionDiagram& diagram : precision_diagrams(rows)) {
        if (!(diagram.margin() >= least_margin)) {
            throw RunError("precision: the reference of the scene '" + diagram.scene + "' is only " +
                           real_text(diagram.margin(), 3) + " times better than the best point, less than " +
                           real_text(least_margin, 3) + ": no chart is drawn");
        }
        if (!diagram.front.empty()) charts.push_back(chart(diagram));
    }
    return charts;
}

}  // namespace drape
