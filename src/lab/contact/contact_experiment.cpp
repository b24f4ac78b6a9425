#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "contact_trial.h"
#include "drape/base/input_error.h"
#include "drape/base/numbers.h"
#include "drape/contact/closest_point.h"
#include "drape/contact/detection.h"
#include "drape/scene/setting_table.h"
#include "lab/experiments.h"

namespace drape {
namespace {

/// Ways to search, by their names in the table, and the settings that make them.
const std::pair<const char*, std::vector<std::string>> contact_searches[] = {
    {"discrete", {}},
    {"continuous", {"contact.continuous=auto"}},
    {"limited", {"contact.search_tests=24"}},
    {"limited", {"contact.search_tests=12"}}};

constexpr Grid hung_grid{25, 25};

/// The particle that is nearest to the ball's way: beside the middle.
const Eigen::Index aim = hung_grid.particle(hung_grid.nx / 2 + 1, hung_grid.ny / 2);

/// A hung cloth of 1 m and a ball on its way through the middle of it, from a quarter of a metre before they meet.
/// @param speed of the ball [m/s]
Settings hung_cloth_and_ball(double speed, const std::vector<std::string>& changes) {
    Settings settings;
    settings.cloths = {{.particles = hung_grid,
                        .plane = Plane::XY,
                        .place = Vec3(Real(-0.5), 1, 0),
                        .pinned = {Pins::Kind::Row, {}},
                        .structural = {400, Real(0.02)},
                        .shear = {200, Real(0.02)},
                        .bend = {5, Real(0.01)}}};
    // A little to the side, so that no triangle is met by symmetry alone
    BallSettings& ball = settings.balls.emplace_back();
    ball.radius = Real(0.15);
    ball.position = Vec3(Real(0.03), Real(0.48), Real(-0.4));
    ball.velocity = Vec3(0, 0, static_cast<Real>(speed));
    settings.ground.solid = false;
    settings.solver.integrator = IntegratorKind::BackwardEuler;
    settings.contact.leaf_cells = 4;
    settings.contact.continuous = Continuous::Never;
    assign_all(settings, changes);
    return settings;
}

/// By the plane of its closest point, as contacts are found, before the carried impulses push it out; a plane of the
/// end does not show what has passed. At the back of the ball the cloth is on the wrong side.
bool touches_front(const ContactTrial& trial, int triangle) {
    const Cloth& cloth = trial.cloths[0];
    const Ball& ball = trial.balls[0];
    const Real thickness = trial.settings.contact.thickness;
    const bool looked_back = cloth.search.reach(body_of(ball, trial.settings.contact), thickness) > 0;
    const Vec3 start = looked_back ? Vec3(ball.centre - ball.moved) : ball.centre;
    const Points &x = trial.unpushed, &before = looked_back ? cloth.previous.x : x;
    const auto corners = cloth.model.grid.triangle_corners(triangle);
    const ClosestPoint closest = closest_point(before, corners, start);
    const auto& [u, v, w] = closest.barycentric;
    const Vec3 normal = (closest.point - start).normalized();
    const Vec3 point = u * position(x, corners[0]) + v * position(x, corners[1]) + w * position(x, corners[2]);
    const Real distance = (point - ball.centre).dot(normal);
    return distance <= ball.radius + thickness && normal.dot(ball.velocity) >= 0;
}

/// Adds the triangles that touch the front of the ball: of the cells that the search has found, of particles that
/// carried impulses have moved out of its reach, and all of a node at which it has ended and that is taken for a
/// contact.
void add_touched(const ContactTrial& trial, std::set<int>& triangles) {
    const Grid& grid = trial.cloths[0].model.grid;
    const Candidates& candidates = trial.cloths[0].search.candidates(0);
    std::vector<bool> found(static_cast<std::size_t>(grid.cells()));
    std::vector<bool> pushed(static_cast<std::size_t>(grid.particles()));
    for (const CellRange& some : candidates.cells) {
        for_each_cell_of(some, [&](int i, int j) { found[static_cast<std::size_t>(grid.cell(i, j))] = true; });
    }
    for (const ContactRow& row : trial.stage.rows()) {
        const bool is_of_ball = row.kind == RowKind::Particle || row.kind == RowKind::Triangle;
        if (!is_of_ball || row.body != 0 || !row.has_impulse()) continue;
        for (const RowParticle& moved : row.moved()) pushed[static_cast<std::size_t>(moved.particle)] = true;
    }
    for (int triangle = 0; triangle < grid.triangles(); ++triangle) {
        const bool is_near = found[static_cast<std::size_t>(triangle / 2)] ||
                             std::ranges::any_of(grid.triangle_corners(triangle),
                                                 [&](int p) { return pushed[static_cast<std::size_t>(p)]; });
        if (is_near && touches_front(trial, triangle)) triangles.insert(triangle);
    }
    for (const StoppedNode& node : candidates.stopped) {
        const auto is_its = [&](const ContactRow& contact) {
            return contact.kind == RowKind::Node && contact.triangle == 2 * node.cell &&
                   contact.normal.dot(trial.balls[0].velocity) >= 0;
        };
        if (std::ranges::none_of(trial.stage.rows(), is_its)) continue;
        for (int cell = 0; cell < grid.cells(); ++cell) {
            if (!node.holds(cell % grid.cell_columns(), cell / grid.cell_columns())) continue;
            triangles.insert({2 * cell, 2 * cell + 1});
        }
    }
}

/// What one run saw.
struct ContactHistory {
    std::vector<std::set<int>> touched;  ///< triangles, within each step
    double entered = 0, left = 0;        ///< largest depth of any triangle before the response, and after it [m]
    double false_contacts = 0;           ///< nodes taken for contacts in which nothing touches, a step
    bool passed = false;                 ///< the ball is past the particle that it was aimed at
    Vec3 momentum = Vec3::Zero();        ///< of the cloth, at the end [kg m/s]
};

/// @param finer steps that each step is made in
ContactHistory watch_contacts(const Settings& settings, std::size_t steps, double step, std::size_t finer) {
    ContactTrial trial(settings);
    const Points& x = trial.cloths[0].state.x;
    ContactHistory history{.touched = std::vector<std::set<int>>(steps)};
    const auto deepen = [&](double& deepest) {
        const Grid& grid = trial.cloths[0].model.grid;
        const Real depth = deepest_penetration(grid, x, trial.balls, settings.contact.thickness);
        deepest = std::max(deepest, static_cast<double>(depth));
    };
    for (std::size_t k = 0; k < steps * finer; ++k) {
        trial.advance(static_cast<Real>(step / static_cast<double>(finer)));
        deepen(history.entered);
        add_touched(trial, history.touched[k / finer]);
        trial.stage.audit_search(trial.report);
        history.false_contacts += static_cast<double>(trial.report.false_contacts) / static_cast<double>(steps * finer);
        trial.respond();
        deepen(history.left);
    }
    history.passed = (x.row(aim).transpose() - trial.balls[0].centre).dot(trial.balls[0].velocity) < 0;
    history.momentum = trial.momentum(0);
    return history;
}

/// CPU time for a simulated second, without the observer.
Quartiles time_run(const Settings& settings, std::size_t steps, double step, int repeats) {
    std::vector<double> costs;
    for (int repeat = -1; repeat < repeats; ++repeat) {
        ContactTrial trial(settings);
        const double seconds = cpu_time_of([&] { trial.advance(static_cast<Real>(step)), trial.respond(); },
                                           static_cast<std::int64_t>(steps));
        if (repeat >= 0) costs.push_back(seconds / step);
    }
    return quartiles_of(std::move(costs));
}

/// `missed_contacts`, part of the triangles that the reference touched within each step, that the run has not found
/// within it, and `missed_steps`, part of the steps in which the reference touched, and the run not at all.
Row misses_of(const ContactHistory& run, const ContactHistory& reference) {
    double contacts = 0, missed_contacts = 0, steps = 0, missed_steps = 0;
    for (std::size_t k = 0; k < run.touched.size(); ++k) {
        const std::set<int>&expected = reference.touched[k], &touched = run.touched[k];
        if (expected.empty()) continue;
        ++steps;
        missed_steps += touched.empty();
        for (const int triangle : expected) ++contacts, missed_contacts += !touched.contains(triangle);
    }
    return {{"missed_contacts", missed_contacts / contacts}, {"missed_steps", missed_steps / steps}};
}

/// @throws RunError if there is nothing to find, or the reference itself fails
Rows run_contact_case(double speed, double step, int repeats) {
    // To an end before the cloth slips off the ball
    const auto steps = static_cast<std::size_t>(std::ceil(0.5 / speed / step));
    // All triangles, and all that may have met within each of its steps
    const Settings closely = hung_cloth_and_ball(speed, {"contact.volume=brute", "contact.continuous=auto"});
    const ContactHistory reference = watch_contacts(closely, steps, step, 100);
    std::set<int> triangles;
    for (const std::set<int>& touched : reference.touched) triangles.insert(touched.begin(), touched.end());
    if (triangles.empty() || reference.passed) {
        throw RunError("contact: at " + real_text(speed) + " m/s the ball of the reference has gone through the cloth");
    }
    Rows rows;
    for (const auto& [name, changes] : contact_searches) {
        const Settings settings = hung_cloth_and_ball(speed, changes);
        const ContactHistory run = watch_contacts(settings, steps, step, 1);
        const auto radius = static_cast<double>(settings.balls[0].radius);
        Row& row = rows.emplace_back(misses_of(run, reference));
        // A ball that has gone through counts with its radius
        row.set({{"search", name},
                 {"tests", settings.contact.search.tests},
                 {"penetration_m", run.passed ? radius : run.entered},
                 {"left_m", run.passed ? radius : run.left},
                 {"momentum_error", (run.momentum - reference.momentum).norm() / reference.momentum.norm()},
                 {"passed", run.passed ? "1" : "0"},
                 {"false_contacts", run.false_contacts},
                 {"cpu_s_per_s", time_run(settings, steps, step, repeats)},
                 {"reference_triangles", triangles.size()},
                 {"reference_penetration_m", reference.left}});
    }
    return rows;
}

}  // namespace

Experiment contact_experiment() {
    return {"contact",
            "which steps and searches find the contacts that there are?",
            8,
            {"search", "tests", "speed_m_per_s", "step_s", "missed_contacts", "missed_steps",
             "penetration_m",  // largest, before the response
             "left_m",         // and after it
             "momentum_error", "passed", "false_contacts",
             quartile_columns("cpu_s_per_s"),  // time for a simulated second
             "reference_triangles", "reference_penetration_m"},
            {{"",
              cases_over(run_contact_case, Axis<double>{"speed_m_per_s", {2, 8, 32}, {0.5, 2, 8, 32}},
                         steps_a_second({30, 60, 120, 240, 480, 960}, {30, 60, 120, 240, 480, 960, 1920}),
                         quick_or_whole(5, 15)),
              {{"contact"}}}}};
}

}  // namespace drape
