#include "experiment_table.h"

#include <fmt/core.h>

#include <iostream>
#include <map>
#include <sstream>

#include "drape/base/child_program.h"
#include "drape/base/input_error.h"
#include "drape/base/input_file.h"
#include "drape/base/numbers.h"
#include "drape/base/output_file.h"
#include "drape/base/resources.h"

namespace drape {
namespace {

/// A shipped file of the charts: a script, or the page.
std::string chart_file(const std::string& name) { return read_text(find_resource("charts/" + name).string()); }

/// A shipped text in which each name between two '$' is replaced by what a row has there.
/// @param file of the text, for the message
std::string filled(const std::string& file, const std::string& text, const Row& row) {
    std::istringstream in(text);
    std::string all;
    for (std::string words, name; std::getline(in, words, '$');) {
        all += words;
        if (!std::getline(in, name, '$')) break;
        if (!row.has(name)) throw RunError("charts/" + file + " has an unknown part: $" + shortened(name) + "$");
        all += row.word(name);
    }
    return all;
}

/// What the head of a chart's script says that it shows, in lines that begin with a mark.
std::string caption_of(const Chart& chart, const std::string& script) {
    constexpr std::string_view mark = "# caption: ";
    const std::string file = chart.script + ".gp";
    std::istringstream text(script);
    std::string caption;
    for (std::string line; std::getline(text, line);) {
        if (line.starts_with(mark)) caption += line.substr(mark.size()) + " ";
    }
    if (caption.empty()) throw RunError("charts/" + file + " has no line '" + std::string(mark) + "'");
    return filled(file, std::string(trimmed(caption)), chart.row);
}

/// Text as a page shows it.
std::string escaped(const std::string& text) {
    static const std::map<char, std::string> marks{{'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}};
    std::string shown;
    for (const char c : text) shown += marks.contains(c) ? marks.at(c) : std::string(1, c);
    return shown;
}

/// The exit code of a script that finds nothing to draw in its table.
constexpr int nothing_to_draw = 3;

/// @param all the table has all cases: that there is nothing to draw is worth a line
/// @return what the page has of the charts that were drawn
std::string figures_of(const std::vector<Chart>& charts, const std::filesystem::path& table, bool all) {
    // gnuplot runs beside the table and knows files by names that are ours: no path is part of its program
    const std::filesystem::path folder = table.has_parent_path() ? table.parent_path() : ".";
    std::string figures;
    for (Chart chart : charts) {
        const std::string name = chart.name, script = name + ".gnuplot";
        chart.values.insert({{"name", quoted(name)}, {"table", quoted(table.filename().string())}});
        const std::string own = chart_file(chart.script + ".gp");
        OutputFile file((folder / script).string());
        file.stream() << "# To draw the chart once more, in this folder: gnuplot " << script << "\n";
        for (const auto& [variable, value] : chart.values) file.stream() << variable << " = " << value << "\n";
        file.stream() << '\n'
                      << chart_file("common.gp") << '\n'
                      << own << "\nunset output\nif (kind eq 'svg') { kind = 'png'; load '" << script << "' }\n";
        file.close();
        const auto code = run_child({"gnuplot", "--default-settings", script}, folder);
        if (!code) {
            std::cerr << "There is no gnuplot (Debian package gnuplot-nox): the charts are not drawn.\n";
            return {};
        }
        if (*code == nothing_to_draw && all) std::cerr << "There is nothing to draw for " << name << ".\n";
        if (*code == nothing_to_draw) continue;
        if (*code != 0) throw RunError("gnuplot failed on " + (folder / script).string());
        figures += fmt::format(
            "<figure>\n<a href=\"{0}.svg\"><img src=\"{0}.svg\" alt=\"{1}\"></a>\n<figcaption>{1}</figcaption>\n"
            "</figure>\n",
            name, escaped(caption_of(chart, own)));
    }
    return figures;
}

}  // namespace

void present(const Experiment& experiment, const ExperimentTable& table, const std::filesystem::path& file) {
    const bool all = table.head.at("settings").find(" --") == std::string::npos;  // neither cases nor a share
    std::string origin;
    for (const char* line : head_lines) {
        origin += fmt::format("<dt>{}</dt><dd>{}</dd>\n", line, escaped(table.head.at(line)));
    }
    const Row parts{{"name", experiment.name},
                    {"question", escaped(experiment.question)},
                    {"figures", figures_of(experiment.charts(table.rows()), file, all)},
                    {"origin", origin},
                    {"table", escaped(file.filename().string())}};
    const std::string name = std::filesystem::path(file).replace_extension(".html").string();
    OutputFile page(name);
    page.stream() << filled("page.html", chart_file("page.html"), parts);
    page.close();
    std::cout << name << "\n";
}

}  // namespace drape
