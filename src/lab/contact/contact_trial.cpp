#include "contact_trial.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "drape/base/assert.h"
#include "drape/contact/closest_point.h"
#include "drape/contact/search_audit.h"
#include "drape/scene/setting_table.h"

namespace drape {
namespace {

int nearest_to_way(const Points& x, const Ball& ball) {
    const Vec3 along = ball.velocity.normalized();
    int nearest = 0;
    Real least = std::numeric_limits<Real>::max();
    for (int p = 0; p < x.rows(); ++p) {
        const Vec3 offset = x.row(p).transpose() - ball.centre;
        const Real square = (offset - offset.dot(along) * along).squaredNorm();
        if (square < least) least = square, nearest = p;
    }
    return nearest;
}

void add_triangles(const Grid& grid, const StoppedNode& node, std::vector<int>& triangles) {
    for (int j = node.j0; j < node.j1; ++j) {
        for (int i = node.i0; i < node.i1; ++i) {
            const int cell = j * grid.cell_columns() + i;
            triangles.push_back(2 * cell);
            triangles.push_back(2 * cell + 1);
        }
    }
}

}  // namespace

ContactScene ContactScene::with(const std::vector<std::string>& assignments) const {
    ContactScene scene = *this;
    assign_all(scene.settings, assignments);
    return scene;
}

ContactTrial::ContactTrial(const ContactScene& scene, Real step)
    : settings_(scene.settings), h_(step), cloths_(settings_.cloths.size()) {
    for (std::size_t c = 0; c < cloths_.size(); ++c) {
        Cloth& cloth = cloths_[c];
        cloth.model = make_cloth_model(settings_.cloths[c]);
        cloth.model.gravity = scene.gravity.value_or(gravity_of(settings_));
        cloth.state = scene.start.empty() ? make_rest_state(settings_.cloths[c]) : scene.start[c];
        cloth.integrator.use(integrator_of(settings_.solver), cloth.model.grid);
        cloth.energy.restart(cloth.model, cloth.state, settings_.solver.kernels);
    }
    for (const BallSettings& ball : settings_.balls) {
        balls_.push_back({.centre = ball.position, .radius = ball.radius, .velocity = ball.velocity});
    }
    if (!balls_.empty()) aim_ = nearest_to_way(state().x, balls_[0]);
    stage_.use(settings_, cloths_);
}

void ContactTrial::advance(Real h) {
    report_.forget_contacts();
    for (Cloth& cloth : cloths_) cloth.previous = cloth.state;
    for (Ball& ball : balls_) {
        ball.moved = h * ball.velocity;
        ball.centre += ball.moved;
    }
    stage_.begin(settings_, {cloths_, balls_, {}}, {.h = h});
    for (Cloth& cloth : cloths_) {
        cloth.integrator.step(cloth.model, cloth.state, h);
        cloth.search.positions_changed();
    }
    unpushed_ = state().x;
    stage_.warm_start();
    stage_.detect(report_);
}

ResponseReport ContactTrial::respond() {
    const ResponseReport left = stage_.solve(report_);
    stage_.end();
    return left;
}

/// By the plane of its closest point, as contacts are found, before the carried impulses push it out; a plane of the
/// end does not show what has passed.
bool ContactTrial::touches_front(int triangle) const {
    const Cloth& cloth = cloths_[0];
    const bool looked_back = cloth.search.looked_back(ball(), settings_.contact.thickness);
    const Vec3 moved = looked_back ? ball().moved : Vec3(0, 0, 0), start = ball().centre - moved;
    const Points &x = unpushed_, &before = moved.isZero(0) ? x : cloth.previous.x;
    const auto [a, b, c] = grid().triangle_corners(triangle);
    const auto at = [](const Points& points, int p) -> Vec3 { return points.row(p).transpose(); };
    const ClosestPoint closest = closest_point_on_triangle(start, at(before, a), at(before, b), at(before, c));
    const auto& [u, v, w] = closest.barycentric;
    const Vec3 normal = (closest.point - start).normalized();
    const Real distance = (u * at(x, a) + v * at(x, b) + w * at(x, c) - ball().centre).dot(normal);
    return distance <= ball().radius + settings_.contact.thickness && normal.dot(ball().velocity) >= 0;
}

std::vector<int> ContactTrial::touched_triangles() const {
    std::vector<int> triangles;
    const auto look_at = [&](int cell, std::optional<int> with_particle = {}) {
        for (const int triangle : {2 * cell, 2 * cell + 1}) {
            const auto corners = grid().triangle_corners(triangle);
            const bool has_it = !with_particle || std::ranges::find(corners, *with_particle) != corners.end();
            if (has_it && touches_front(triangle)) triangles.push_back(triangle);
        }
    };
    for (const CellRun& run : cloths_[0].search.candidates(0).cells) {
        const int first = run.row * grid().cell_columns() + run.column;
        for (int cell = first; cell < first + run.count; ++cell) look_at(cell);
    }
    // What carried impulses have moved out of the search's reach is a contact that was found
    constexpr int ball_of_scene = 0;
    for (const ContactRow& row : stage_.rows()) {
        const bool is_of_ball = row.kind == RowKind::Particle || row.kind == RowKind::Triangle;
        if (!is_of_ball || row.body != ball_of_scene || !row.has_impulse()) continue;
        for (const RowParticle& moved : row.moved()) {
            const int i = moved.particle % grid().nx, j = moved.particle / grid().nx;
            for (int r = std::max(j - 1, 0); r < std::min(j + 1, grid().cell_rows()); ++r) {
                for (int c = std::max(i - 1, 0); c < std::min(i + 1, grid().cell_columns()); ++c) {
                    look_at(r * grid().cell_columns() + c, moved.particle);
                }
            }
        }
    }
    for (const StoppedNode& node : stopped()) {
        const auto is_its = [&](const ContactRow& contact) {
            return contact.kind == RowKind::Node && contact.triangle == 2 * node.cell &&
                   contact.normal.dot(ball().velocity) >= 0;
        };
        if (std::ranges::any_of(stage_.rows(), is_its)) add_triangles(grid(), node, triangles);
    }
    std::ranges::sort(triangles);
    triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
    return triangles;
}

bool ContactTrial::has_passed() const {
    return (state().x.row(aim_).transpose() - ball().centre).dot(ball().velocity) < 0;
}

Vec3 ContactTrial::momentum(std::size_t cloth) const {
    return cloths_[cloth].model.particle_mass * state(cloth).v.colwise().sum().transpose();
}

ContactHistory watch_contacts(const ContactScene& scene, Real step) {
    ContactTrial trial(scene, step);
    const Real thickness = scene.settings.contact.thickness;
    SearchAudit audit(trial.grid(), scene.settings.solver.kernels);
    ContactHistory history;
    const auto deepen = [&](double& deepest) {
        const Real depth = audit.penetration(trial.state().x, std::span(&trial.ball(), 1), thickness);
        deepest = std::max(deepest, static_cast<double>(depth));
    };
    const auto steps = std::llround(scene.end / static_cast<double>(step));
    for (std::int64_t k = 0; k < steps; ++k) {
        trial.advance();
        deepen(history.entered);
        history.touched.push_back(trial.touched_triangles());
        if (!trial.stopped().empty()) {
            const std::int64_t found = audit.false_contacts(trial.state().x, trial.ball(), thickness, trial.stopped());
            history.false_contacts += static_cast<double>(found) / static_cast<double>(steps);
        }
        trial.respond();
        deepen(history.left);
    }
    history.passed = trial.has_passed();
    history.momentum = trial.momentum();
    return history;
}

Row compare_contacts(const ContactHistory& run, const ContactHistory& reference, int finer) {
    std::size_t contacts = 0, missed_contacts = 0, steps = 0, missed_steps = 0;
    for (std::size_t k = 0; k < run.touched.size(); ++k) {
        std::set<int> expected;
        for (std::size_t fine = 0; fine < static_cast<std::size_t>(finer); ++fine) {
            const std::vector<int>& touched = reference.touched[k * static_cast<std::size_t>(finer) + fine];
            expected.insert(touched.begin(), touched.end());
        }
        if (expected.empty()) continue;
        ++steps;
        missed_steps += run.touched[k].empty() ? 1 : 0;
        contacts += expected.size();
        missed_contacts += static_cast<std::size_t>(std::ranges::count_if(
            expected, [&](int triangle) { return !std::ranges::binary_search(run.touched[k], triangle); }));
    }
    DRAPE_ASSERT(contacts > 0);
    const auto part = [](std::size_t missed, std::size_t all) {
        return static_cast<double>(missed) / static_cast<double>(all);
    };
    return {{"missed_contacts", part(missed_contacts, contacts)},
            {"missed_steps", part(missed_steps, steps)},
            {"momentum_error", (run.momentum - reference.momentum).norm() / reference.momentum.norm()},
            {"passed", run.passed && !reference.passed ? "1" : "0"}};
}

}  // namespace drape
