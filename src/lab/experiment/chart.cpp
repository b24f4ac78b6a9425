#include "chart.h"

#include <algorithm>
#include <cmath>
#include <fstream>

#include "drape/base/child_program.h"
#include "drape/base/input_error.h"
#include "drape/base/numbers.h"
#include "drape/base/output_file.h"
#include "drape/base/resources.h"

namespace drape {
namespace {

/// Whether a text has only letters, digits and some other characters: nothing that gnuplot or a shell would run.
bool is_plain(const std::string& text, std::string_view others) {
    return std::ranges::all_of(text, [others](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               others.find(c) != std::string_view::npos;
    });
}

std::string checked(const std::string& text, std::string_view others = "_") {
    if (text.empty() && others == "_") throw RunError("a chart's value has no name");
    if (!is_plain(text, others)) throw RunError("a chart's script may not be told '" + shortened(text) + "'");
    return text;
}

std::string text_of(double number) {
    if (!std::isfinite(number)) throw RunError("a chart's script may not be told a number that is not finite");
    return real_text(number);
}

std::string text_of(const std::string& words) { return "'" + checked(words, "_ :.+-") + "'"; }

void add_script(OutputFile& file, const std::string& name) {
    std::ifstream script(find_resource("charts/" + name + ".gp"));
    file.stream() << '\n' << script.rdbuf();
    if (!script) throw RunError("charts/" + name + ".gp cannot be read");
}

}  // namespace

std::string in_words(const std::vector<std::string>& words) {
    std::string all;
    for (const std::string& word : words) all += (all.empty() ? "" : " ") + word;
    return all;
}

std::string assignments_of(const Chart& chart) {
    std::string text;
    for (const auto& [name, value] : chart.values) {
        text += checked(name) + " = " + std::visit([](const auto& some) { return text_of(some); }, value) + "\n";
    }
    return text;
}

bool draw_charts(const std::vector<Chart>& charts, const std::filesystem::path& table) {
    // gnuplot runs beside the table and knows files by names that are ours: no path is part of its program
    const std::filesystem::path folder = table.has_parent_path() ? table.parent_path() : ".";
    for (Chart chart : charts) {
        const std::string name = checked(chart.name), script = name + ".gnuplot";
        chart.values.insert({{"name", name}, {"table", table.filename().string()}});
        if (!chart.data.empty()) {
            chart.values["data"] = name + "_data.csv";
            OutputFile data((folder / (name + "_data.csv")).string());
            data.stream() << chart.data;
            data.close();
        }
        OutputFile file((folder / script).string());
        file.stream() << "# To draw the chart once more, in this folder: gnuplot " << script << "\n"
                      << assignments_of(chart);
        add_script(file, "common");
        add_script(file, chart.script);
        file.stream() << "\nunset output\nif (kind eq 'svg') { kind = 'png'; load '" << script << "' }\n";
        file.close();
        const auto code = run_child({"gnuplot", "--default-settings", script}, folder);
        if (!code) return false;
        if (*code != 0) throw RunError("gnuplot failed on " + (folder / script).string());
    }
    return true;
}

}  // namespace drape
