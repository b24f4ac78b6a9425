#include "gnuplot.h"

#include "drape/base/child_program.h"
#include "drape/base/input_error.h"
#include "drape/base/output_file.h"

namespace drape {
namespace {

/// A name as gnuplot reads it back.
std::string quoted(const std::filesystem::path& path) {
    std::string text = "'";
    for (const char c : path.string()) text += c == '\'' ? "''" : std::string(1, c);
    return text + "'";
}

}  // namespace

bool draw_charts(const std::vector<Chart>& charts, const std::filesystem::path& table) {
    for (const Chart& chart : charts) {
        const auto base = table.parent_path() / chart.name;
        const std::string script = base.string() + ".gnuplot";
        OutputFile file(script);
        file.stream() << "table = " << quoted(table) << "\nset datafile separator ','\nset datafile columnheaders\n";
        for (const std::string kind : {"svg", "png"}) {
            file.stream() << "set terminal " << (kind == "png" ? "pngcairo" : "svg background rgb 'white'")
                          << " enhanced font 'DejaVu Sans,11' size " << chart.width << ',' << chart.height
                          << "\nset output " << quoted(base.string() + "." + kind) << '\n'
                          << chart.plot << "unset output\n";
        }
        file.close();
        const auto code = run_child({"gnuplot", script});
        if (!code) return false;
        if (*code != 0) throw RunError("gnuplot failed on " + script);
    }
    return true;
}

}  // namespace drape
