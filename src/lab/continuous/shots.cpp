#include "shots.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "drape/base/exact_math.h"
#include "drape/base/input_error.h"
#include "drape/bounds/broad_phase.h"
#include "drape/contact/contact.h"
#include "drape/contact/impact.h"

namespace drape {
namespace {

constexpr Real shot_radius = Real(0.01);

/// A square about the origin at right angles to y.
Points flat_square(const Grid& grid, Real width) {
    const auto along = [width](int k, int n) {
        return width * (static_cast<Real>(k) / static_cast<Real>(n - 1) - Real(0.5));
    };
    Points x(grid.particles(), 3);
    for (int j = 0; j < grid.ny; ++j) {
        for (int i = 0; i < grid.nx; ++i) x.row(grid.particle(i, j)) << along(i, grid.nx), 0, along(j, grid.ny);
    }
    return x;
}

/// Both ways to detect, over one cloth.
class Detector {
public:
    explicit Detector(const Grid& grid) : grid_(grid), tree_(make_broad_phase({.update = UpdateKind::Merge}, grid)) {
        list_all_cells(grid, all_);
    }

    void build(const Points& x) { tree_->build(x); }
    void build(const Points& from, const Points& to) { tree_->build(from, to); }

    bool touches(const Points& x, const Vec3& centre, Real radius) {
        const Ball ball{.centre = centre, .radius = radius};
        tree_->query(ball, found_);
        contacts_.clear();
        find_contacts(grid_, x, ball, 0, 0, found_.cells, contacts_, Kernels::Vector);
        return !contacts_.empty();
    }

    bool meets(const Points& from, const Points& to, const SweptBall& ball) {
        tree_->query(ball, found_);
        impacts_.clear();
        find_impacts(grid_, from, to, ball, found_.cells, impacts_);
        return !impacts_.empty();
    }

    /// Whether all cells together meet as many triangles as `meets` has just found.
    bool is_confirmed(const Points& from, const Points& to, const SweptBall& ball) {
        expected_.clear();
        find_impacts(grid_, from, to, ball, all_, expected_);
        return expected_.size() == impacts_.size();
    }

private:
    Grid grid_;
    std::unique_ptr<BroadPhase> tree_;
    std::vector<CellRun> all_;
    Candidates found_;
    std::vector<Contact> contacts_;
    std::vector<TriangleImpact> impacts_, expected_;
};

/// A way past the origin: the centre at the distance s from the point next to it is middle + s direction.
struct Way {
    Vec3 middle, direction;
};

class RandomWays {
public:
    Way past(Target target) {
        if (target == Target::Sheet) return {Real(0.05) * Vec3(draw(), 0, draw()), Vec3(0, draw() < 0 ? -1 : 1, 0)};
        const Vec3 direction = anywhere();
        Vec3 aside = direction.cross(anywhere());
        aside.normalize();
        return {shot_radius * std::sqrt(std::abs(draw())) * aside, direction};
    }

    Real draw() { return draw_even<Real>(random_); }

private:
    /// Of length 1, even over the sphere.
    Vec3 anywhere() {
        for (;;) {
            const Vec3 p(draw(), draw(), draw());
            const Real square = p.squaredNorm();
            if (square > Real(0.01) && square < 1) return p / std::sqrt(square);
        }
    }

    std::mt19937 random_{29};
};

/// The times of one way to detect, step by step.
struct Laps {
    std::vector<double> build, search;

    [[nodiscard]] DetectionTimes quartiles() const { return {quartiles_of(build), quartiles_of(search)}; }
};

template <class Build, class Search>
void take_laps(Laps& laps, const Build& build, const Search& search) {
    constexpr int in_a_row = 16;  // a search is shorter than what the clock takes
    const double begin = thread_cpu_time();
    build();
    const double built = thread_cpu_time();
    for (int k = 0; k < in_a_row; ++k) search();
    laps.build.push_back(built - begin);
    laps.search.push_back((thread_cpu_time() - built) / in_a_row);
}

}  // namespace

ShotCount shoot(Target target, double q, int shots) {
    const bool point = target == Target::Point;
    const Grid grid = point ? Grid{2, 2} : Grid{20, 20};
    const Points x = flat_square(grid, point ? shot_radius * Real(1e-4) : Real(0.2));
    Detector detector(grid);
    detector.build(x, x);
    RandomWays ways;
    ShotCount count{.shots = static_cast<double>(shots)};
    const Real step = 2 * shot_radius * static_cast<Real>(q);
    for (int shot = 0; shot < shots; ++shot) {
        const Way way = ways.past(target);
        bool discrete = false, continuous = false;
        for (Real s = -2 * shot_radius - step * std::abs(ways.draw()); s < 2 * shot_radius; s += step) {
            const SweptBall ball{way.middle + s * way.direction, way.middle + (s + step) * way.direction, shot_radius};
            discrete = discrete || detector.touches(x, ball.start, shot_radius);
            continuous = detector.meets(x, x, ball) || continuous;
            if (!detector.is_confirmed(x, x, ball)) throw RunError("continuous: a tree misses an impact");
        }
        count.discrete += !discrete;
        count.continuous += !continuous;
    }
    return count;
}

double predicted_misses(Target target, double q) {
    if (target == Target::Sheet) return q <= 1 ? 0 : 1 - 1 / q;
    return q <= 1 ? q * q / 3 : 1 - 2 / (3 * q);
}

BothDetections time_detections(int side, int steps) {
    const Grid grid{side, side};
    Points from = flat_square(grid, 1), to = from;
    Detector discrete(grid), continuous(grid);
    Laps whole, swept;
    RandomWays ways;
    const Real radius = Real(0.05), path = Real(10) / 60;
    for (int step = -2; step < steps; ++step) {
        from = to;
        const Real bend = Real(0.05) * ways.draw(), move = Real(0.05) * ways.draw();
        to.col(1) = (bend * (to.col(0).array() * to.col(2).array()) + move).matrix();
        const Way way = ways.past(Target::Sheet);
        const Vec3 start = way.middle + path * (std::abs(ways.draw()) - 1) * way.direction;
        const SweptBall ball{start, start + path * way.direction, radius};
        take_laps(
            whole, [&] { discrete.build(to); }, [&] { discrete.touches(to, ball.end, radius); });
        take_laps(
            swept, [&] { continuous.build(from, to); }, [&] { continuous.meets(from, to, ball); });
        if (step < 0) whole = {}, swept = {};  // they have warmed the caches
    }
    return {whole.quartiles(), swept.quartiles()};
}

}  // namespace drape
