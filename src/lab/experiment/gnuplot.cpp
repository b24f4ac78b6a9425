#include "gnuplot.h"

#include <algorithm>

#include "chart_text.h"
#include "drape/base/child_program.h"
#include "drape/base/input_error.h"
#include "drape/base/output_file.h"

namespace drape {
namespace {

/// A name that is a file's in every folder, and nothing else to a shell or to gnuplot.
bool is_plain(const std::string& name) {
    return !name.empty() && std::ranges::all_of(name, [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
    });
}

}  // namespace

bool draw_charts(const std::vector<Chart>& charts, const std::filesystem::path& table) {
    // gnuplot runs beside the table and knows files by names that are ours: no path is part of its program
    const std::filesystem::path folder = table.has_parent_path() ? table.parent_path() : ".";
    for (const Chart& chart : charts) {
        if (!is_plain(chart.name)) throw RunError("a chart's name has other characters than letters, digits and '_'");
        const std::string script = chart.name + ".gnuplot";
        OutputFile file((folder / script).string());
        file.stream() << "# To draw the chart once more, in this folder: gnuplot " << script
                      << "\ntable = " << in_quotes(table.filename().string())
                      << "\nset datafile separator ','\nset datafile columnheaders\n";
        for (const std::string kind : {"svg", "png"}) {
            file.stream() << "set terminal " << (kind == "png" ? "pngcairo" : "svg background rgb 'white'")
                          << " enhanced font 'DejaVu Sans,11' size " << chart.width << ',' << chart.height
                          << "\nset output " << in_quotes(chart.name + "." + kind) << '\n'
                          << chart.plot << "unset output\n";
        }
        file.close();
        const auto code = run_child({"gnuplot", "--default-settings", script}, folder);
        if (!code) return false;
        if (*code != 0) throw RunError("gnuplot failed on " + (folder / script).string());
    }
    return true;
}

}  // namespace drape
