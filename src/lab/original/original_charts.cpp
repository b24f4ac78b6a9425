#include "drape/base/numbers.h"
#include "lab/experiment/chart_text.h"
#include "original_experiment.h"

namespace drape {
namespace {

namespace at = original_column;

/// A way as it is drawn, in one of Okabe and Ito's colours; hatched where bounds are in the picture.
std::string look_of(const OriginalWay& way) {
    return (way.bounds_drawn ? "fs pattern 4 " : "fs solid 0.85 ") +
           coloured(way.volume == "sphere" ? "#D55E00" : "#0072B2");
}

std::string title_of(const OriginalWay& way) {
    return (way.volume == "sphere" ? "spheres" : "boxes (AABB)") + std::string(way.bounds_drawn ? ", drawn" : "");
}

/// Bars from a list of "place,median,lower,upper,text", which a datablock of this name holds.
std::string bars(const std::string& data, const std::string& look) {
    return "$" + data + " using 1:2:3:4:(0.8) with boxerrorbars " + look + " lw 1.2 notitle, \\\n     $" + data +
           " using 1:4:5 with labels font ',9' offset 0,0.7 notitle";
}

/// The panels of a chart: their datablocks first, their plots after.
struct Panels {
    std::string data, plots;
};

std::string line_of_bar(double place, const Quartiles& figure, double factor, int digits) {
    const auto text = [&](double value) { return real_text(factor * value, 8); };
    return real_text(place) + "," + text(figure.median) + "," + text(figure.lower) + "," + text(figure.upper) + "," +
           real_text(factor * figure.median, digits) + "\n";
}

void add_block(Panels& panels, const std::string& name, const std::string& lines) {
    panels.data += "$" + name + " << EOD\nplace,median,lower,upper,text\n" + lines + "EOD\n";
}

/// One of the five tests: a bar a way, and the prototype's.
void add_test(Panels& panels, const std::vector<TableRow>& rows, std::size_t number) {
    const OriginalTest& test = original_tests[number];
    std::string items;
    for (std::size_t k = 0; k < original_ways().size(); ++k) {
        const auto figure = original_figure(rows, original_ways()[k], test.column);
        if (!figure) continue;
        const std::string name = "test" + std::to_string(number) + std::to_string(k);
        add_block(panels, name, line_of_bar(static_cast<double>(k), *figure, test.factor, test.digits));
        items += bars(name, look_of(original_ways()[k])) + ", \\\n     ";
    }
    const std::string name = "published" + std::to_string(number);
    const double figure = test.published;
    add_block(panels, name, line_of_bar(4, {figure, figure, figure}, 1, 6));
    panels.plots +=
        "set title " + in_quotes(test.name) + "\nplot " + items + bars(name, "fs solid 0.6 lc rgb '#999999'") + "\n";
}

/// Build and search of the scene's tree and of one down to single cells.
void add_search(Panels& panels, const std::vector<TableRow>& rows) {
    constexpr std::size_t columns[] = {at::Build, at::Search, at::SingleBuild, at::SingleSearch};
    std::string items;
    for (std::size_t k = 0; k < 2; ++k) {
        std::string lines;
        for (std::size_t group = 0; group < 4; ++group) {
            const Quartiles figure = original_search_figure(rows, original_ways()[k].volume, columns[group]);
            lines += line_of_bar(static_cast<double>(3 * group + k), figure, 1e6, 2);
        }
        const std::string name = "search" + std::to_string(k);
        add_block(panels, name, lines);
        items += (k == 0 ? "" : ", \\\n     ") + bars(name, look_of(original_ways()[k]));
    }
    panels.plots +=
        "set title 'one build, one search [us], logarithmic'\nset logscale y\nset yrange [0.05:1000]\nset xrange "
        "[-0.8:10.8]\nset xtics scale 0 ('build' 0.5, 'search' 3.5, "
        "\"build,\\nsingle cells\" 6.5, \"search,\\nsingle cells\" 9.5)\nplot " +
        items + "\n";
}

/// What the colours mean, in the margin below.
std::string key() {
    std::string text =
        "unset border\nunset logscale\nunset tics\nunset title\nunset grid\nset xrange [0:1]\nset yrange [0:1]\nset "
        "lmargin screen "
        "0.05\n"
        "set rmargin screen 0.95\nset bmargin screen 0\nset tmargin screen 0.06\nset key at screen 0.5,0.03 center "
        "center "
        "horizontal maxrows 1 samplen 2 width 1\nplot 2 notitle, \\\n     ";
    for (const OriginalWay& way : original_ways()) {
        text += "keyentry with boxes " + look_of(way) + " title " + in_quotes(title_of(way)) + ", \\\n     ";
    }
    return text + "keyentry with boxes fs solid 0.6 lc rgb '#999999' title \"the dissertation's prototype\"\n";
}

}  // namespace

std::vector<Chart> original_charts(const std::vector<TableRow>& rows) {
    if (rows.empty()) return {};
    Panels panels;
    for (std::size_t number = 0; number < original_tests.size(); ++number) add_test(panels, rows, number);
    add_search(panels, rows);
    return {
        {"original", 1280, 760,
         panels.data +
             "set multiplot layout 2,3 title \"The original's five tests: a cloth on a ball, spheres against "
             "boxes\" font ',13' margins 0.055,0.985,0.13,0.89 spacing 0.06,0.12\n"
             "set grid ytics lt 1 lc rgb '#e0e0e0'\nset border 3\nset tics nomirror\nset boxwidth 0.8\n"
             "set offsets 0,0,graph 0.12,0\nset yrange [0:*]\nset xrange [-0.7:4.7]\n"
             "set xtics scale 0 ('sphere' 0, 'AABB' 1, 'sphere' 2, 'AABB' 3, 'original' 4)\nunset key\n" +
             panels.plots + key() + "unset multiplot\nreset\nset datafile separator ','\nset datafile columnheaders\n",
         "The five tests, medians over runs with quartiles, and the figures that the dissertation gives for its "
         "prototype. Hatched: the bounds of a level are in the picture, as the original drew its spheres. Execution "
         "is the CPU time of all steps of a frame, without drawing. Last: one build and one search, with the "
         "scene's leaves of 7 x 7 cells and with a tree down to single cells."}};
}

}  // namespace drape
