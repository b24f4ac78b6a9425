#include <algorithm>
#include <map>

#include "drape/base/numbers.h"
#include "lab/experiment/chart_text.h"
#include "stability_experiment.h"

namespace drape {
namespace {

namespace at = stability_column;

/// What one chart says about its method.
struct Charted {
    double side = 0;  ///< of the sheet that is drawn
    int trials = 0, against = 0;
    bool limited = false;
    bool stiffness = false, damping = false;  ///< which were swept; a share of the cases may lack one
};

std::string title(const std::string& method, const Charted& charted) {
    std::string name = method;
    std::replace(name.begin(), name.end(), '_', ' ');
    const std::string side = real_text(charted.side);
    return name + ", " + side + " x " + side + " particles: " + std::to_string(charted.trials) + " trials, " +
           std::to_string(charted.against) +
           (charted.limited ? " against the prediction" : " not bounded (there is no linear limit)");
}

/// One panel: bounded and failed steps over a swept quantity, and the limits as lines.
std::string panel(const std::string& method, const Charted& charted, const std::string& sweep, const std::string& swept,
                  const std::string& label) {
    const std::string here = "strcol('method') eq " + in_quotes(method) + " && strcol('sweep') eq " + in_quotes(sweep) +
                             " && column('side') == " + real_text(charted.side);
    const std::string x = "table using (" + column(swept) + "):(";
    const auto points = [&](const std::string& condition, const std::string& style) {
        return x + here + " && " + condition + " ? column('step_s') : NaN) with points " + style;
    };
    const auto line = [&](const std::string& of, const std::string& style) {
        return x + here + " ? " + column(of) + " : NaN) with lines " + style;
    };
    std::string text = "set xlabel '" + label + "'\nplot " +
                       points("strcol('end') eq 'bounded'", "pt 7 ps 0.7 lc rgb '#0072B2' title 'stayed bounded'") +
                       ", \\\n     " +
                       points("strcol('end') ne 'bounded'", "pt 2 ps 0.9 lw 1.5 lc rgb '#D55E00' title 'failed'");
    if (charted.limited) {
        const bool two_lines = method == "explicit_euler";
        text += ", \\\n     " +
                line("expected_step_s", std::string("lw 2 lc rgb 'black' title '") +
                                            (two_lines ? "where growth from noise shows" : "predicted limit") + "'");
        if (two_lines) {
            text += ", \\\n     " + line("predicted_step_s",
                                         "lw 2 dt 2 lc rgb '#009E73' title 'limit for endless runs (none undamped)'");
        }
        text += ", \\\n     " + points("strcol('verdict') eq 'disagrees'",
                                       "pt 4 ps 1.8 lw 1.5 lc rgb '#CC79A7' title 'against the prediction'");
    }
    return text + "\n";
}

Chart chart(const std::string& method, const Charted& charted) {
    return {
        "stability_" + method, 1100, 560,
        "set multiplot layout 1,2 title " + in_quotes(title(method, charted)) +
            " font ',13' margins 0.085,0.98,0.235,0.87 spacing 0.09,0\n"
            "set logscale xy\nset format '10^{%L}'\nset grid xtics ytics lt 1 lc rgb '#e0e0e0'\nset offsets graph "
            "0.04, graph 0.04, "
            "graph 0, graph 0\n"
            "set ylabel 'step [s]'\nset key at screen 0.5,0.075 center center vertical maxrows 2 samplen 2 width -2\n" +
            (charted.stiffness ? panel(method, charted, "stiffness", "stiffness_N_per_m",
                                       "stiffness of every spring [N/m], undamped") +
                                     "unset key\nset ylabel ''\n"
                               : std::string("set multiplot next\n")) +
            (charted.damping ? panel(method, charted, "damping", "damping_N_s_per_m",
                                     "damping of every spring [N s/m], stiffness 10^4 N/m")
                             : std::string()) +
            "unset multiplot\nreset\nset datafile separator ','\nset datafile columnheaders\n",
        charted.limited ? "Steps that stayed bounded and steps that failed, over stiffness and damping, and the "
                          "longest step that is predicted: every dot should lie below the line, every cross above it."
                        : "Steps that stayed bounded and steps that failed, over stiffness and damping, under a "
                          "method that has no linear limit: a cross is a failure that no linear theory predicts."};
}

}  // namespace

std::vector<Chart> stability_charts(const std::vector<TableRow>& rows) {
    // The sheet that is drawn is the last of its method; the damped sweep of stiffness is for the table only
    const auto drawn = [](const TableRow& row) { return row[at::Sweep] != "damped_stiffness"; };
    std::map<std::string, Charted> methods;
    for (const TableRow& row : rows) {
        if (drawn(row)) methods[row[at::Method]].side = number_in(row[at::Side]);
    }
    for (const TableRow& row : rows) {
        if (!drawn(row)) continue;
        Charted& charted = methods[row[at::Method]];
        if (charted.side != number_in(row[at::Side])) continue;
        ++charted.trials;
        charted.against += row[at::Verdict] == "disagrees" ? 1 : 0;
        charted.limited = row[at::Expected] != "inf";
        (row[at::Sweep] == "stiffness" ? charted.stiffness : charted.damping) = true;
    }
    std::vector<Chart> charts;
    for (const auto& [method, charted] : methods) charts.push_back(chart(method, charted));
    return charts;
}

}  // namespace drape
