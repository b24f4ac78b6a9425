#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

#include "drape/base/exact_math.h"
#include "drape/base/input_error.h"
#include "drape/bounds/broad_phase.h"
#include "drape/bounds/leaf_copies.h"
#include "drape/contact/detection.h"
#include "lab/experiments.h"

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

/// Where cloth was at the start of a step, and is at its end, n x 3 [m].
struct ClothMotion {
    const Points &before, &x;
};

/// Detection over one cloth.
class Detector {
public:
    explicit Detector(const Grid& grid) : grid_(grid), tree_(make_broad_phase({.update = UpdateKind::Merge}, grid)) {
        list_all_cells(grid, all_);
    }

    void build(const Points& x) { tree_->build(x); }

    /// Whether cloth and ball touch at the end of a step, or, with a reach, within it.
    /// @param reach by how much they may have come nearer to each other [m]
    bool touches(const ClothMotion& cloth, const Ball& ball, Real reach) {
        tree_->query(grown(ball, 2 * reach), found_);
        contacts_.clear();
        return find_contacts({grid_, cloth.before, cloth.x}, ball, {.reach = reach}, found_.cells, contacts_,
                             Kernels::Vector) > 0;
    }

    /// Whether all cells together have as many contacts as `touches` has just found.
    bool is_confirmed(const ClothMotion& cloth, const Ball& ball, Real reach) {
        expected_.clear();
        find_contacts({grid_, cloth.before, cloth.x}, ball, {.reach = reach}, all_, expected_, Kernels::Plain);
        return expected_.size() == contacts_.size();
    }

private:
    Grid grid_;
    std::unique_ptr<BroadPhase> tree_;
    std::vector<CellRun> all_;
    Candidates found_;
    std::vector<ContactRow> contacts_, expected_;
};

/// A way past the origin: the centre at the distance s from the point next to it is middle + s direction.
struct Way {
    Vec3 middle, direction;
};

class RandomWays {
public:
    Way past_sheet() { return {Real(0.05) * Vec3(draw(), 0, draw()), Vec3(0, draw() < 0 ? -1 : 1, 0)}; }

    /// At a distance that is even over the ball's disc, in a direction that is even over all.
    Way past_point() {
        const Vec3 direction = anywhere();
        Vec3 aside = direction.cross(anywhere());
        aside.normalize();
        return {shot_radius * std::sqrt(std::abs(draw())) * aside, direction};
    }

    Real draw() { return uniform<Real>(random_); }

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

/// A detector whose steps are timed.
class TimedDetector {
public:
    explicit TimedDetector(const Grid& grid) : detector_(grid) {}

    /// @param search uses the detector, after it has been built
    template <class Search>
    void step(const Points& x, const Search& search) {
        constexpr int in_a_row = 16;  // a search is shorter than what the clock takes
        build_.push_back(cpu_time_of([&] { detector_.build(x); }));
        search_.push_back(cpu_time_of([&] {
                              for (int k = 0; k < in_a_row; ++k) search(detector_);
                          }) /
                          in_a_row);
    }

    void forget() { build_.clear(), search_.clear(); }

    [[nodiscard]] Row row(const Grid& grid, const char* name) const {
        return {{"part", "time"},
                {"detection", name},
                {"particles", grid.particles()},
                {"build_s", quartiles_of(build_)},
                {"search_s", quartiles_of(search_)}};
    }

private:
    Detector detector_;
    std::vector<double> build_, search_;
};

/// The part that discrete detection misses. A chord at the distance b from a ball's centre is c = 2 sqrt(R^2 - b^2)
/// long, and is stepped over with the probability 1 - c / (2 R q), if that is positive. With b even over the disc its
/// mean is q^2 / 3 for q <= 1 and 1 - 2 / (3 q) above. A sheet's chord is always 2 R long: 0, and 1 - 1 / q above.
double predicted_misses(bool point, double q) {
    if (point) return q <= 1 ? q * q / 3 : 1 - 2 / (3 * q);
    return q <= 1 ? 0 : 1 - 1 / q;
}

/// Shoots a ball through a cloth at rest, in steps of q of its diameters: q = v dt / (2 R). The cloth is a point, a
/// ten thousandth as wide as the ball, or a wide flat sheet at right angles to the way. The first step is even within
/// one. A shot is missed that passes unseen, though its way passes the target nearer than the ball's radius.
/// @throws RunError if a tree does not find the contacts that all cells have
Rows misses_at(const std::string& target, double q, int shots) {
    const bool point = target == "point";
    const Grid grid = point ? Grid{2, 2} : Grid{20, 20};
    const Points x = flat_square(grid, point ? shot_radius * Real(1e-4) : Real(0.2));
    Detector detector(grid);
    detector.build(x);
    RandomWays ways;
    int discrete_missed = 0, continuous_missed = 0;
    const Real step = 2 * shot_radius * static_cast<Real>(q);
    for (int shot = 0; shot < shots; ++shot) {
        const Way way = point ? ways.past_point() : ways.past_sheet();
        bool discrete = false, continuous = false;
        for (Real s = -2 * shot_radius - step * (1 + std::abs(ways.draw())); s < 2 * shot_radius; s += step) {
            const Vec3 moved = step * way.direction, centre = way.middle + s * way.direction + moved;
            const Ball ball{.centre = centre, .radius = shot_radius, .moved = moved};
            discrete = discrete || detector.touches({x, x}, ball, 0);
            continuous = detector.touches({x, x}, ball, step) || continuous;
            if (!detector.is_confirmed({x, x}, ball, step)) throw RunError("continuous: a tree misses a contact");
        }
        discrete_missed += !discrete;
        continuous_missed += !continuous;
    }
    return {{{"part", "misses"},
             {"target", target},
             {"q", q},
             {"shots", shots},
             {"discrete_missed", static_cast<double>(discrete_missed) / shots},
             {"continuous_missed", static_cast<double>(continuous_missed) / shots},
             {"predicted", predicted_misses(point, q)}}};
}

/// CPU times of both ways to detect in turn, over steps in which a ball of 5 cm at 10 m/s meets a sheet that moves.
/// @param side particles along each side of the sheet
Rows times_of(int side, int steps) {
    const Grid grid{side, side};
    Points from = flat_square(grid, 1), to = from;
    TimedDetector discrete(grid), continuous(grid);
    RandomWays ways;
    const Real radius = Real(0.05), path = Real(10) / 60;
    for (int step = -2; step < steps; ++step) {
        from = to;
        const Real bend = Real(0.05) * ways.draw(), move = Real(0.05) * ways.draw();
        to.col(1) = (bend * (to.col(0).array() * to.col(2).array()) + move).matrix();
        const Way way = ways.past_sheet();
        const Vec3 start = way.middle + path * (std::abs(ways.draw()) - 1) * way.direction;
        const Vec3 moved = path * way.direction;
        const Ball ball{.centre = start + moved, .radius = radius, .moved = moved};
        discrete.step(to, [&](Detector& detector) { detector.touches({to, to}, ball, 0); });
        continuous.step(to, [&](Detector& detector) {
            detector.touches({from, to}, ball, largest_displacement(to, from, Kernels::Vector) + path);
        });
        if (step < 0) discrete.forget(), continuous.forget();  // they have warmed the caches
    }
    return {discrete.row(grid, "discrete"), continuous.row(grid, "continuous")};
}

ExperimentCases miss_cases(bool quick) {
    return cases_over(
        [=](const std::string& target, double q) { return misses_at(target, q, quick ? 5'000 : 100'000); },
        std::vector<std::string>{"point", "sheet"},
        quick
            ? std::vector{0.5, 1.0, 2.0, 8.0}
            : std::vector{0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 1.0, 1.25, 1.5, 2.0, 3.0, 4.0, 8.0, 16.0, 83.0});
}

ExperimentCases time_cases(bool quick) {
    return cases_over([=](int side) { return times_of(side, quick ? 31 : 101); },
                      quick ? std::vector{32, 64} : std::vector{16, 32, 64, 128, 256, 512});
}

std::vector<Chart> miss_charts(const Rows& rows) {
    return {{"continuous_misses", {{"targets", in_words(words_of(rows, "target"))}}}};
}

std::vector<Chart> time_charts(const Rows& rows) {
    return {{"continuous_time", {{"detections", in_words(words_of(rows, "detection"))}}}};
}

}  // namespace

Experiment continuous_experiment() {
    return {"continuous",
            "what passes unseen between two steps, and what does it cost to see it?",
            6,
            {word_column("part", {"misses", "time"}), word_column("target", {"point", "sheet", "none"}),
             word_column("detection", {"discrete", "continuous", "none"}),
             positive_column("q").or_nan(),  // v dt / (2 R)
             whole_column("shots", 1).or_nan(),
             number_column("discrete_missed").or_nan(),  // part of the shots
             number_column("continuous_missed").or_nan(), number_column("predicted").or_nan(),
             whole_column("particles", 4).or_nan(), number_column("build_s").or_nan().with_quartiles(),
             number_column("search_s").or_nan().with_quartiles()},
            {{"part", "target", "detection", "q", "particles"},
             {"discrete_missed", "predicted", "continuous_missed", "build_s", "search_s"}},
            {{"misses", miss_cases, miss_charts}, {"time", time_cases, time_charts}}};
}

}  // namespace drape
