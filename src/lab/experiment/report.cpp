#include "experiment_table.h"

#include <fmt/core.h>

#include <cmath>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>

#include "drape/base/child_program.h"
#include "drape/base/input_error.h"
#include "drape/base/numbers.h"
#include "drape/base/output_file.h"
#include "drape/base/resources.h"

namespace drape {
namespace {

/// A text that has only letters, digits and some other characters: nothing that gnuplot or a shell would run.
std::string checked(const std::string& text, const std::string& others) {
    const std::string plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_" + others;
    if (text.find_first_not_of(plain) == std::string::npos) return text;
    throw RunError("invalid characters in a chart's text: '" + shortened(text) + "'");
}

std::string checked_name(const std::string& text) {
    if (text.empty()) throw RunError("a chart's value has no name");
    return checked(text, "");
}

std::string text_of(double number) {
    if (!std::isfinite(number)) throw RunError("a chart's script may not be told a number that is not finite");
    return real_text(number);
}

std::string text_of(const std::string& words) { return "'" + checked(words, " :.+-") + "'"; }

std::string script_text(const std::string& name) {
    std::ifstream script(find_resource("charts/" + name + ".gp"));
    std::ostringstream text;
    text << script.rdbuf();
    if (!script) throw RunError("charts/" + name + ".gp cannot be read");
    return text.str();
}

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
        const std::string name = checked_name(chart.name), script = name + ".gnuplot";
        chart.values.insert({{"name", name}, {"table", table.filename().string()}});
        const std::string own_name = chart.script.empty() ? name : chart.script, own = script_text(own_name);
        OutputFile file((folder / script).string());
        file.stream() << "# To draw the chart once more, in this folder: gnuplot " << script << "\n"
                      << assignments_of(chart) << '\n'
                      << script_text("common") << '\n'
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

constexpr const char* style =
    "body{font:16px/1.5 'DejaVu Sans',sans-serif;color:#222;max-width:72rem;margin:2rem auto;padding:0 1rem}"
    "h1{font-size:1.5rem}figure{margin:2.5rem 0}img{max-width:100%;height:auto;border:1px solid #ddd}"
    "figcaption{max-width:50rem;color:#444}pre{overflow-x:auto;background:#f6f6f6;padding:1rem;font-size:.85rem}"
    "dl{display:grid;grid-template-columns:max-content auto;gap:.1rem 1.5rem;font-size:.85rem}dd{margin:0}";

/// Question, charts with captions, what was found, and where it is from.
void write_report_page(const Experiment& experiment, const TableHead& head, const std::string& figures,
                       const std::string& summary, const std::filesystem::path& table) {
    std::string lines;
    for (const char* line : head_lines) {
        lines += fmt::format("<dt>{}</dt><dd>{}</dd>\n", line, escaped(head.at(line)));
    }
    OutputFile file((table.parent_path() / "index.html").string());
    file.stream() << fmt::format(
        R"(<!doctype html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width">
<title>Drape: {0}</title>
<style>{1}</style>
<h1>{0}: {2}</h1>
{3}<h2>What was found</h2>
<pre>{4}</pre>
<h2>Where it is from</h2>
<dl>
{5}<dt>table</dt><dd><a href="{6}">{6}</a></dd>
</dl>
</html>
)",
        experiment.name, style, escaped(experiment.question), figures, escaped(summary), lines,
        escaped(table.filename().string()));
    file.close();
}

}  // namespace

std::string assignments_of(const Chart& chart) {
    std::string text;
    for (const auto& [name, value] : chart.values) {
        text += checked_name(name) + " = " + std::visit([](const auto& some) { return text_of(some); }, value) + "\n";
    }
    return text;
}

void present(const Experiment& experiment, const ExperimentTable& table, const std::filesystem::path& file) {
    const auto rows = table.rows();
    const std::string summary = summary_of(experiment, rows);
    std::cout << summary;
    const bool all = table.head.at("settings").find(" --") == std::string::npos;  // neither cases nor a share
    write_report_page(experiment, table.head, figures_of(experiment.charts(rows), file, all), summary, file);
}

}  // namespace drape
