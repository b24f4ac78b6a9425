// Drape's hierarchy beside those of FCL, Bullet and Embree, on the same motion, one thread. See docs/hierarchy.md.

#include <algorithm>
#include <cstdio>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

#include "drape/base/command_line.h"
#include "drape/base/input_error.h"
#include "drape/base/output_file.h"
#include "drape/base/run_program.h"
#include "race.h"

namespace drape::peers {
namespace {

constexpr const char* precision = sizeof(Real) == sizeof(double) ? "double" : "single";

double fastest_of_ours(const std::vector<Result>& results) {
    double fastest = std::numeric_limits<double>::infinity();
    for (const Result& r : results) {
        if (r.ours) fastest = std::min(fastest, r.total);
    }
    return fastest;
}

double mean_touched(const Motion& motion) {
    double touched = 0;
    for (const Frame& frame : motion.frames) touched += static_cast<double>(frame.touched.size());
    return touched / static_cast<double>(motion.frames.size()) / motion.grid.triangles();
}

void print(const Motion& motion, const std::vector<Result>& results) {
    const double fastest = fastest_of_ours(results);
    std::printf("\n%d x %d particles, %s precision, %.1f %% of %d triangles touched\n\n", motion.grid.nx,
                motion.grid.ny, precision, 100 * mean_touched(motion), motion.grid.triangles());
    std::printf("| %-28s | update us | query us |  total us |  ratio | frames | ties |\n", "method");
    std::printf("| %s | --------: | -------: | --------: | -----: | -----: | ---: |\n", std::string(28, '-').c_str());
    for (const Result& r : results) {
        std::printf("| %-28s | %9.1f | %8.1f | %9.1f | %6.1f | %6d | %4d |\n", r.method.c_str(), r.update * 1e6,
                    r.query * 1e6, r.total * 1e6, r.total / fastest, r.frames, r.ties);
    }
    std::fflush(stdout);
}

void write(const Motion& motion, const std::vector<Result>& results, std::ostream& out) {
    const double fastest = fastest_of_ours(results);
    for (const Result& r : results) {
        out << precision << ',' << motion.grid.nx << ',' << r.method << ',' << r.update * 1e6 << ',' << r.query * 1e6
            << ',' << r.total * 1e6 << ',' << r.total / fastest << ',' << r.frames << ',' << r.ties << '\n';
    }
}

int run(int argc, char** argv) {
    CommandLine line("peers", "Times Drape's hierarchy beside those of FCL, Bullet and Embree.");
    std::string csv;
    bool quick = false;
    line.option("--csv", csv, "Also write the figures to this file");
    line.flag("--quick", quick, "Two sizes, few frames");
    if (!line.parse(argc, argv)) return Done;

    OutputFile file(csv);
    file.stream() << "precision,side,method,update_us,query_us,total_us,ratio,frames,ties\n";
    const std::vector<int> sides = quick ? std::vector{32, 128} : std::vector{32, 128, 512};
    for (const int side : sides) {
        const Motion motion(side, quick ? 8 : 32);
        const std::vector<Result> results = race(motion, quick ? 2 : 5);
        print(motion, results);
        if (file.wanted()) write(motion, results, file.stream());
    }
    file.close();
    return Done;
}

}  // namespace
}  // namespace drape::peers

int main(int argc, char** argv) { return drape::run_program("peers", argc, argv, drape::peers::run); }
