// Drape's hierarchies beside those of FCL, Bullet and Embree, on the same frames, one thread. With a ball: the
// triangles that it touches, see docs/hierarchy.md. With --self: pairs of triangles of the cloths of `fold` and `stack`
// that may touch, see docs/contact-measured.md.

#include <fmt/core.h>

#include <algorithm>
#include <ostream>

#include "ball_race.h"
#include "drape/base/command_line.h"
#include "drape/base/input_error.h"
#include "drape/base/numbers.h"
#include "drape/base/output_file.h"
#include "drape/base/run_program.h"
#include "pair_race.h"

namespace drape::peers {
namespace {

constexpr bool in_double = sizeof(Real) == sizeof(double);

template <class Task>
std::vector<Result> race(const Task& task, int turns) {
    Runners runners;
    add_ours(runners, task);
    add_fcl(runners, task);
    add_bullet(runners, task);
    add_embree(runners, task);
    return take_turns(runners, turns);
}

/// @param reference the time that ratios are of [s]
/// @param task, counts the columns before the method, and before the ties
void tell_all(const std::vector<Result>& results, double reference, const std::string& task, const std::string& counts,
              std::ostream& out) {
    for (const Result& r : results) {
        tell(out, fmt::format("{},{},{:.6g},{:.6g},{:.6g},{:.6g},{}{},{}", task, r.method, r.update * 1e6,
                              r.query * 1e6, r.total * 1e6, r.total / reference, r.frames, counts, r.ties));
    }
}

void race_with_a_ball(bool quick, std::ostream& out) {
    tell(out, "precision,side,method,update_us,query_us,total_us,ratio,frames,ties");
    for (const int side : quick ? std::vector{32, 128} : std::vector{32, 128, 512}) {
        const std::vector<Result> results = race(Motion(side, quick ? 8 : 32), quick ? 2 : 5);
        // Of Drape's trees; the first of its methods is brute force
        double fastest = results.at(1).total;
        for (const Result& r : results) {
            if (r.method.starts_with("Drape") && &r != &results.front()) fastest = std::min(fastest, r.total);
        }
        tell_all(results, fastest, (in_double ? "double," : "single,") + std::to_string(side), "", out);
    }
}

/// A mean over the frames.
std::string mean_of(const Sheets& sheets, std::vector<TrianglePair> SheetFrame::*pairs) {
    double sum = 0;
    for (const SheetFrame& frame : sheets.frames) sum += static_cast<double>((frame.*pairs).size());
    return real_text(sum / static_cast<double>(sheets.frames.size()), 6);
}

void race_for_pairs(bool quick, std::ostream& out) {
    tell(out, "scene,side,triangles,method,update_us,query_us,total_us,ratio,frames,box_pairs,near_pairs,ties");
    for (const std::string scene : {"fold", "stack"}) {
        for (const int side : quick ? std::vector{32} : std::vector{32, 64, 128}) {
            const Sheets sheets(scene, side, quick ? 4 : 8);
            const std::vector<Result> results = race(sheets, quick ? 1 : 3);
            // The first of ours finds what the other libraries find
            tell_all(results, results.front().total,
                     scene + ',' + std::to_string(side) + ',' + std::to_string(sheets.triangles()),
                     ',' + mean_of(sheets, &SheetFrame::boxes) + ',' + mean_of(sheets, &SheetFrame::near), out);
        }
    }
}

int run(int argc, char** argv) {
    CommandLine line("peers", "Times Drape beside others: its hierarchies, its cloth and its solvers.");
    std::string csv;
    bool quick = false, self = false, cloth = false, solve = false;
    line.option("--csv", csv, "Also write the figures to this file");
    line.flag("--quick", quick, "Fewer sizes, few frames");
    line.flag("--self", self, "Pairs of triangles of cloth, in place of a ball and a cloth");
    line.flag("--cloth", cloth, "A sheet moved by Drape and by Bullet");
    line.flag("--solve", solve, "The system of an implicit step, by solvers of Drape, Eigen, CHOLMOD and hypre");
    if (!line.parse(argc, argv)) return Done;
    if (self + cloth + solve > 1) throw InputError("--self, --cloth, --solve: allowed: one of them");
    if (!in_double && (self || cloth || solve)) throw InputError("--self, --cloth, --solve: double precision only");

    OutputFile file(csv);
    if (self) {
        race_for_pairs(quick, file.stream());
    } else if constexpr (in_double) {
        if (cloth) race_with_cloth(quick, file.stream());
        if (solve) race_to_solve(quick, file.stream());
    }
    if (!self && !cloth && !solve) race_with_a_ball(quick, file.stream());
    file.close();
    return Done;
}

}  // namespace
}  // namespace drape::peers

int main(int argc, char** argv) { return drape::run_program("peers", argc, argv, drape::peers::run); }
