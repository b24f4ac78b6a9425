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

/// What the head of a script says that its chart shows, in lines that begin with a mark; then more.
/// @param name of the script, for the message
std::string caption_of(const std::string& name, const std::string& script, const std::string& more) {
    constexpr std::string_view mark = "# caption: ";
    std::istringstream text(script);
    std::string caption;
    for (std::string line; std::getline(text, line);) {
        if (line.starts_with(mark)) caption += line.substr(mark.size()) + " ";
    }
    if (caption.empty()) throw RunError("charts/" + name + ".gp has no line '" + std::string(mark) + "'");
    return std::string(trimmed(caption + more));
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
        const std::string own_name = chart.script.empty() ? name : chart.script, own = chart_file(own_name + ".gp");
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
            name, escaped(caption_of(own_name, own, chart.caption)));
    }
    return figures;
}

/// Question, charts with captions, and where it is from.
void write_report_page(const Experiment& experiment, const TableHead& head, const std::string& figures,
                       const std::filesystem::path& table) {
    std::string origin;
    for (const char* line : head_lines) {
        origin += fmt::format("<dt>{}</dt><dd>{}</dd>\n", line, escaped(head.at(line)));
    }
    const std::map<std::string, std::string> parts{{"name", experiment.name},
                                                   {"question", escaped(experiment.question)},
                                                   {"figures", figures},
                                                   {"origin", origin},
                                                   {"table", escaped(table.filename().string())}};
    const std::string name = std::filesystem::path(table).replace_extension(".html").string();
    OutputFile file(name);
    std::istringstream page(chart_file("page.html"));
    // The name of a part stands between two '$'
    for (std::string text, part; std::getline(page, text, '$');) {
        file.stream() << text;
        if (!std::getline(page, part, '$')) break;
        if (!parts.contains(part)) throw RunError("charts/page.html has an unknown part: $" + shortened(part) + "$");
        file.stream() << parts.at(part);
    }
    file.close();
    std::cout << name << "\n";
}

}  // namespace

void present(const Experiment& experiment, const ExperimentTable& table, const std::filesystem::path& file) try {
    const bool all = table.head.at("settings").find(" --") == std::string::npos;  // neither cases nor a share
    write_report_page(experiment, table.head, figures_of(experiment.charts(table.rows()), file, all), file);
} catch (const InputError& error) {
    throw InputError(file.string() + ": " + error.what());
}

}  // namespace drape
