#include <Eigen/Geometry>

#include <cmath>

#include "drape/base/exact_math.h"
#include "drape/base/input_error.h"
#include "drape/bounds/broad_phase.h"
#include "drape/bounds/displacement.h"
#include "drape/contact/detection.h"
#include "lab/experiments.h"

namespace drape {
namespace {

constexpr Real shot_radius = Real(0.01);
constexpr unsigned seed = 29;

/// A square about the origin at right angles to y.
Points flat_square(int side, Real width) {
    const auto along = [=](int k) { return width * (static_cast<Real>(k) / static_cast<Real>(side - 1) - Real(0.5)); };
    Points x(side * side, 3);
    for (int p = 0; p < side * side; ++p) x.row(p) << along(p % side), 0, along(p / side);
    return x;
}

/// Detection over one cloth, and what it keeps.
struct Detector {
    explicit Detector(const Grid& grid) : tree(make_broad_phase({.update = UpdateKind::Merge}, grid)) {}

    /// Whether cloth and ball touch at the end of a step, or, with a reach, within it.
    /// @param reach by how much they may have come nearer to each other [m]
    bool touches(const MovingCloth& cloth, const Ball& ball, Real reach) {
        tree->query(grown(ball, 2 * reach), found);
        contacts.clear();
        return find_contacts(cloth, ball, {.reach = reach}, found.cells, contacts, Kernels::Vector) > 0;
    }

    std::unique_ptr<BroadPhase> tree;
    Candidates found;
    std::vector<ContactRow> contacts;
};

/// A way past the origin: the centre at the distance s from the point next to it is middle + s direction.
struct Way {
    Vec3 middle, direction;
};

/// Of length 1, even over the sphere.
Vec3 any_direction(std::mt19937& random) {
    for (;;) {
        const Vec3 p(uniform<Real>(random), uniform<Real>(random), uniform<Real>(random));
        const Real square = p.squaredNorm();
        if (square > Real(0.01) && square < 1) return p / std::sqrt(square);
    }
}

Way past_sheet(std::mt19937& random) {
    return {Real(0.05) * Vec3(uniform<Real>(random), 0, uniform<Real>(random)),
            Vec3(0, uniform<Real>(random) < 0 ? -1 : 1, 0)};
}

/// At a distance that is even over the ball's disc, in a direction that is even over all.
Way past_point(std::mt19937& random) {
    const Vec3 direction = any_direction(random);
    const Vec3 aside = direction.cross(any_direction(random)).normalized();
    return {shot_radius * std::sqrt(std::abs(uniform<Real>(random))) * aside, direction};
}

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
    const Points x = flat_square(grid.nx, point ? shot_radius * Real(1e-4) : Real(0.2));
    const MovingCloth cloth{grid, x, x};
    Detector detector(grid);
    detector.tree->build(x);
    const CellRange all = all_cells(grid);
    std::vector<ContactRow> expected;
    std::mt19937 random(seed);
    double discrete_missed = 0, continuous_missed = 0;
    const Real step = 2 * shot_radius * static_cast<Real>(q);
    for (int shot = 0; shot < shots; ++shot) {
        const Way way = point ? past_point(random) : past_sheet(random);
        bool discrete = false, continuous = false;
        for (Real s = -2 * shot_radius - step * (1 + std::abs(uniform<Real>(random))); s < 2 * shot_radius; s += step) {
            const Vec3 moved = step * way.direction, centre = way.middle + s * way.direction + moved;
            const Ball ball{.centre = centre, .radius = shot_radius, .moved = moved};
            discrete = discrete || detector.touches(cloth, ball, 0);
            continuous = detector.touches(cloth, ball, step) || continuous;
            expected.clear();
            find_contacts(cloth, ball, {.reach = step}, {&all, 1}, expected, Kernels::Plain);
            if (expected.size() != detector.contacts.size()) throw RunError("continuous: a tree misses a contact");
        }
        discrete_missed += !discrete;
        continuous_missed += !continuous;
    }
    return {{{"discrete_missed", discrete_missed / shots},
             {"continuous_missed", continuous_missed / shots},
             {"predicted", predicted_misses(point, q)}}};
}

/// CPU times of both ways to detect in turn, over steps in which a ball of 5 cm at 10 m/s meets a sheet that moves.
/// @param side particles along each side of the sheet
Rows times_of(int side, int steps) {
    const Grid grid{side, side};
    Points from = flat_square(side, 1), to = from;
    struct TimedDetector {
        bool continuous;
        Detector detector;
        std::vector<double> build = {}, search = {};
    };
    TimedDetector timed[] = {{false, Detector(grid)}, {true, Detector(grid)}};
    std::mt19937 random(seed);
    const Real radius = Real(0.05), path = Real(10) / 60;
    for (int step = -2; step < steps; ++step) {
        from = to;
        const Real bend = Real(0.05) * uniform<Real>(random), move = Real(0.05) * uniform<Real>(random);
        to.col(1) = (bend * (to.col(0).array() * to.col(2).array()) + move).matrix();
        const Way way = past_sheet(random);
        const Vec3 start = way.middle + path * (std::abs(uniform<Real>(random)) - 1) * way.direction;
        const Vec3 moved = path * way.direction;
        const Ball ball{.centre = start + moved, .radius = radius, .moved = moved};
        for (TimedDetector& one : timed) {
            const auto search = [&] {
                const Real reach = one.continuous ? largest_displacement(to, from) + path : 0;
                one.detector.touches({grid, one.continuous ? from : to, to}, ball, reach);
            };
            constexpr int in_a_row = 16;  // a search is shorter than what the clock takes
            const double build = cpu_time_of([&] { one.detector.tree->build(to); });
            const double searched = cpu_time_of(search, in_a_row);
            if (step < 0) continue;  // it has warmed the caches
            one.build.push_back(build);
            one.search.push_back(searched);
        }
    }
    Rows rows;
    for (const TimedDetector& one : timed) {
        rows.push_back({{"detection", one.continuous ? "continuous" : "discrete"},
                        {"particles", grid.particles()},
                        {"build_s", quartiles_of(one.build)},
                        {"search_s", quartiles_of(one.search)}});
    }
    return rows;
}

}  // namespace

Experiment continuous_experiment() {
    return {"continuous",
            "what passes unseen between two steps, and what does it cost to see it?",
            6,
            {"part", Column{"target", "none"}, Column{"detection", "none"},
             "q",  // v dt / (2 R)
             "shots",
             "discrete_missed",  // part of the shots
             "continuous_missed", "predicted", "particles", quartile_columns("build_s"), quartile_columns("search_s")},
            {{"misses",
              cases_over(misses_at, Axis<std::string>{"target", {"point", "sheet"}},
                         Axis<double>{"q",
                                      {0.5, 1, 2, 8},
                                      {0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 1, 1.25, 1.5, 2, 3, 4, 8, 16, 83}},
                         Axis<int>{"shots", {5'000}, {100'000}}),
              {{"continuous_misses"}}},
             {"time",
              cases_over(times_of, Axis<int>{"", {32, 64}, {16, 32, 64, 128, 256, 512}}, quick_or_whole(31, 101)),
              {{"continuous_time"}}}}};
}

}  // namespace drape
