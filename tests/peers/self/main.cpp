// Pairs of triangles of cloth that may touch: Drape's hierarchies beside those of FCL, Bullet and Embree, on the same
// frames of `fold` and `stack`, one thread, double precision but for Embree. See docs/contact.md.

#include <algorithm>
#include <cstdio>
#include <ostream>

#include "drape/base/command_line.h"
#include "drape/base/input_error.h"
#include "drape/base/output_file.h"
#include "drape/base/run_program.h"
#include "pair_method.h"
#include "peers/runner.h"

namespace drape::peers {
namespace {

class PairRunner final : public Runner {
public:
    PairRunner(std::unique_ptr<PairMethod> method, const Sheets& sheets, bool ours)
        : Runner(method->name(), sheets.frames.size(), ours), method_(std::move(method)), sheets_(sheets) {
        method_->start(sheets, sheets.frames.back());
    }

private:
    void prepare(std::size_t frame) override {
        frame_.of_cloths = sheets_.frames[frame].of_cloths;
        frame_.x = sheets_.frames[frame].x;
        found_.clear();
    }
    void update() override { method_->update(frame_); }
    void query() override { method_->query(found_); }

    /// Every pair that is sought is there, each once, and the rest are those that rounding decides, or may be found.
    int check(std::size_t frame) override {
        const SheetFrame& expected = sheets_.frames[frame];
        std::ranges::sort(found_);
        if (std::ranges::adjacent_find(found_) != found_.end()) throw RunError("a pair is found twice");
        const auto& sought = method_->sought() == Sought::Boxes ? expected.boxes : expected.near;
        std::vector<TrianglePair> lost, more;
        std::ranges::set_difference(sought, found_, std::back_inserter(lost));
        if (!lost.empty()) {
            throw RunError("lost " + std::to_string(lost.size()) + " of " + std::to_string(sought.size()) +
                           " pairs, the first of triangles " + std::to_string(lost[0].first) + " and " +
                           std::to_string(lost[0].second));
        }
        std::ranges::set_difference(found_, expected.boxes, std::back_inserter(more));
        std::vector<Aabb> boxes;
        if (!more.empty()) make_boxes(sheets_, frame_.x, boxes);
        for (const auto& [a, b] : more) {
            const Aabb &one = boxes[static_cast<std::size_t>(a)], &two = boxes[static_cast<std::size_t>(b)];
            if (meet(one, two, sheets_.thickness + Real(1e-12))) continue;
            throw RunError("triangles " + std::to_string(a) + " and " + std::to_string(b) + " are too far apart");
        }
        return static_cast<int>(more.size());
    }

    std::unique_ptr<PairMethod> method_;
    const Sheets& sheets_;
    SheetFrame frame_;
    std::vector<TrianglePair> found_;
};

std::vector<Result> race(const Sheets& sheets, int turns) {
    PairMethods methods;
    add_our_pairs(methods);
    const std::size_t ours = methods.size();
    add_fcl_pairs(methods);
    add_bullet_pairs(methods);
    add_embree_pairs(methods);
    std::vector<std::unique_ptr<Runner>> runners;
    for (std::size_t m = 0; m < methods.size(); ++m) {
        runners.push_back(std::make_unique<PairRunner>(std::move(methods[m]), sheets, m < ours));
    }
    return take_turns(runners, turns);
}

/// A mean over the frames.
double mean_of(const Sheets& sheets, std::vector<TrianglePair> SheetFrame::*pairs) {
    double sum = 0;
    for (const SheetFrame& frame : sheets.frames) sum += static_cast<double>((frame.*pairs).size());
    return sum / static_cast<double>(sheets.frames.size());
}

void write(const Sheets& sheets, const std::vector<Result>& results, std::ostream& out) {
    // The first of ours finds what the other libraries find
    const double first = results.front().total;
    for (const Result& r : results) {
        out << sheets.scene << ',' << sheets.side << ',' << sheets.triangles() << ',' << r.method << ','
            << r.update * 1e6 << ',' << r.query * 1e6 << ',' << r.total * 1e6 << ',' << r.total / first << ','
            << r.frames << ',' << mean_of(sheets, &SheetFrame::boxes) << ',' << mean_of(sheets, &SheetFrame::near)
            << ',' << r.ties << '\n';
    }
}

void print(const Sheets& sheets, const std::vector<Result>& results) {
    std::printf("\n%s, %d a side: %d triangles, %.0f pairs of boxes, %.0f of them near\n", sheets.scene.c_str(),
                sheets.side, sheets.triangles(), mean_of(sheets, &SheetFrame::boxes),
                mean_of(sheets, &SheetFrame::near));
    for (const Result& r : results) {
        std::printf("%-28s update %8.1f us, query %9.1f us, total %9.1f us, %6.2f, %d frames, %d ties\n",
                    r.method.c_str(), r.update * 1e6, r.query * 1e6, r.total * 1e6, r.total / results.front().total,
                    r.frames, r.ties);
    }
    std::fflush(stdout);
}

int run(int argc, char** argv) {
    CommandLine line("peers_self", "Times pairs of cloth's triangles by Drape's hierarchies, FCL, Bullet and Embree.");
    std::string csv;
    bool quick = false;
    line.option("--csv", csv, "Also write the figures to this file");
    line.flag("--quick", quick, "One size, few frames");
    if (!line.parse(argc, argv)) return Done;

    OutputFile file(csv);
    file.stream() << "scene,side,triangles,method,update_us,query_us,total_us,ratio,frames,box_pairs,near_pairs,ties\n";
    for (const std::string scene : {"fold", "stack"}) {
        for (const int side : quick ? std::vector{32} : std::vector{32, 64, 128}) {
            const Sheets sheets(scene, side, quick ? 4 : 8);
            const std::vector<Result> results = race(sheets, quick ? 1 : 3);
            print(sheets, results);
            if (file.wanted()) write(sheets, results, file.stream());
        }
    }
    file.close();
    return Done;
}

}  // namespace
}  // namespace drape::peers

int main(int argc, char** argv) { return drape::run_program("peers_self", argc, argv, drape::peers::run); }
