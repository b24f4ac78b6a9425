#include "gnuplot.h"

#include <spawn.h>
#include <sys/wait.h>

#include <array>
#include <cerrno>

#include "drape/base/output_file.h"

extern char** environ;

namespace drape {
namespace {

/// Runs gnuplot in this folder's name space on a script; false if there is none.
bool run_gnuplot(const std::string& script) {
    std::string program = "gnuplot", file = script;
    const std::array<char*, 3> arguments{program.data(), file.data(), nullptr};
    pid_t process = -1;
    const int error = posix_spawnp(&process, "gnuplot", nullptr, nullptr, arguments.data(), environ);
    if (error == ENOENT) return false;
    int status = -1;
    while (error == 0 && waitpid(process, &status, 0) < 0 && errno == EINTR) continue;
    if (error != 0 || !WIFEXITED(status) || WEXITSTATUS(status) != 0) throw RunError("gnuplot failed on " + script);
    return true;
}

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
        if (!run_gnuplot(script)) return false;
    }
    return true;
}

}  // namespace drape
