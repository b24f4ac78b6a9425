#include "pair_race.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "crossings/self_scenes.h"
#include "drape/base/input_error.h"
#include "drape/contact/closest_point.h"
#include "drape/sim/simulation.h"

namespace drape::peers {
namespace {

constexpr double start = 0.5, frame_time = 1.0 / 60;  // [s]
constexpr int finest_simulated = 64;

void lay_out(Sheets& sheets, const Settings& settings) {
    int particles = 0;
    for (const ClothParameters& cloth : settings.cloths) {
        const ClothModel model = make_cloth_model(cloth);
        sheets.grids.push_back(model.grid);
        sheets.spacings.push_back({model.hx, model.hy});
        sheets.first_triangles.push_back(sheets.triangles());
        for (int t = 0; t < model.grid.triangles(); ++t) {
            auto corners = model.grid.triangle_corners(t);
            for (int& corner : corners) corner += particles;
            sheets.corners.push_back(corners);
        }
        particles += model.grid.particles();
    }
}

SheetFrame frame_of(const Sheets& sheets, const Simulation& simulation) {
    SheetFrame frame;
    Eigen::Index particles = 0;
    for (std::size_t c = 0; c < sheets.grids.size(); ++c) {
        const Cloth& cloth = simulation.cloths()[c];
        frame.of_cloths.push_back(resampled(cloth.state.x, cloth.model.grid, sheets.grids[c]));
        particles += frame.of_cloths[c].rows();
    }
    frame.x.resize(particles, 3);
    Eigen::Index row = 0;
    for (const Points& x : frame.of_cloths) {
        frame.x.middleRows(row, x.rows()) = x;
        row += x.rows();
    }
    return frame;
}

using Corners = std::array<Vec3, 3>;

/// Of two triangles that do not cross, whose closest points are those of a corner and a triangle, or of two edges.
Real distance(const Corners& a, const Corners& b) {
    Real square = std::numeric_limits<Real>::infinity();
    const auto look = [&square](const Vec3& offset) { square = std::min(square, offset.squaredNorm()); };
    for (std::size_t i = 0; i < 3; ++i) {
        look(closest_point_on_triangle(a[i], b[0], b[1], b[2]).point - a[i]);
        look(closest_point_on_triangle(b[i], a[0], a[1], a[2]).point - b[i]);
        for (std::size_t k = 0; k < 3; ++k) {
            look(closest_of_segments(a[i], a[(i + 1) % 3], b[k], b[(k + 1) % 3]).offset);
        }
    }
    return std::sqrt(square);
}

Corners corners_of(const Sheets& sheets, const Points& x, int triangle) {
    const auto [a, b, c] = sheets.corners[static_cast<std::size_t>(triangle)];
    return {x.row(a).transpose(), x.row(b).transpose(), x.row(c).transpose()};
}

/// Fills `boxes` and `near` of a frame by comparing every triangle with every other whose extent along x meets its own.
void find_all_pairs(const Sheets& sheets, SheetFrame& frame) {
    std::vector<Aabb> boxes;
    make_boxes(sheets, frame.x, boxes);
    const auto box = [&boxes](int triangle) -> const Aabb& { return boxes[static_cast<std::size_t>(triangle)]; };
    std::vector<int> along_x(boxes.size());
    std::iota(along_x.begin(), along_x.end(), 0);
    std::ranges::sort(along_x, {}, [&](int triangle) { return box(triangle).low.x(); });
    // Twice the thickness: rounding is to play no part in where a row of comparisons ends
    for (auto a = along_x.begin(); a != along_x.end(); ++a) {
        const Real end = box(*a).high.x() + 2 * sheets.thickness;
        for (auto b = a + 1; b != along_x.end() && box(*b).low.x() <= end; ++b) {
            if (!meet(box(*a), box(*b), sheets.thickness) || sheets.share_particle(*a, *b)) continue;
            frame.boxes.push_back(in_order(*a, *b));
        }
    }
    std::ranges::sort(frame.boxes);
    std::ranges::copy_if(frame.boxes, std::back_inserter(frame.near), [&](const TrianglePair& pair) {
        const auto first = corners_of(sheets, frame.x, pair.first), second = corners_of(sheets, frame.x, pair.second);
        return distance(first, second) <= sheets.thickness;
    });
}

}  // namespace

void make_boxes(const Sheets& sheets, const Points& x, std::vector<Aabb>& boxes) {
    boxes.clear();
    for (const auto& [a, b, c] : sheets.corners) {
        Aabb box{x.row(a).transpose(), x.row(a).transpose()};
        box.include(Vec3(x.row(b).transpose()));
        box.include(Vec3(x.row(c).transpose()));
        boxes.push_back(box);
    }
}

Sheets::Sheets(const std::string& name, int side_of_grid, int count) : scene(name), side(side_of_grid) {
    const Settings as_raced = crossings::scene_of_side(scene, side);
    thickness = response_of(as_raced).pair_thickness;
    lay_out(*this, as_raced);
    // By XPBD, whose long steps get there sooner
    Settings settings = crossings::scene_of_side(scene, std::min(side, finest_simulated));
    settings.solver.sleep_speed = 0;
    crossings::use_method(settings, IntegratorKind::Xpbd);
    settings.solver.iterations = 3;
    Simulation simulation(scene, settings);
    for (int f = 0; f < count; ++f) {
        while (simulation.report().time < start + f * frame_time) simulation.step();
        frames.push_back(frame_of(*this, simulation));
        find_all_pairs(*this, frames.back());
    }
}

PairMethod::PairMethod(std::string name, const Sheets& sheets, Sought sought)
    : Runner(std::move(name), sheets.frames.size()),
      sheets_(sheets),
      sought_(sought),
      of_cloths_(sheets.frames.back().of_cloths),
      x_(sheets.frames.back().x) {}

void PairMethod::prepare(std::size_t frame) {
    of_cloths_ = sheets_.frames[frame].of_cloths;
    x_ = sheets_.frames[frame].x;
    found_.clear();
}

/// Every pair that is sought is there, each once, and the rest are those that rounding decides, or may be found.
int PairMethod::check(std::size_t frame) {
    const SheetFrame& expected = sheets_.frames[frame];
    std::ranges::sort(found_);
    if (std::ranges::adjacent_find(found_) != found_.end()) throw RunError("a pair is found twice");
    const auto& sought = sought_ == Sought::Boxes ? expected.boxes : expected.near;
    std::vector<TrianglePair> lost, more;
    std::ranges::set_difference(sought, found_, std::back_inserter(lost));
    if (!lost.empty()) {
        throw RunError("lost " + std::to_string(lost.size()) + " of " + std::to_string(sought.size()) +
                       " pairs, the first of triangles " + std::to_string(lost[0].first) + " and " +
                       std::to_string(lost[0].second));
    }
    std::ranges::set_difference(found_, expected.boxes, std::back_inserter(more));
    std::vector<Aabb> boxes;
    if (!more.empty()) make_boxes(sheets_, x_, boxes);
    for (const auto& [a, b] : more) {
        const Aabb &one = boxes[static_cast<std::size_t>(a)], &two = boxes[static_cast<std::size_t>(b)];
        if (meet(one, two, sheets_.thickness + Real(1e-12))) continue;
        throw RunError("triangles " + std::to_string(a) + " and " + std::to_string(b) + " are too far apart");
    }
    return static_cast<int>(more.size());
}

}  // namespace drape::peers
