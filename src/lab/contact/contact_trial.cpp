#include "contact_trial.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "drape/base/assert.h"
#include "drape/contact/node_contacts.h"
#include "drape/contact/search_audit.h"

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

ContactTrial::ContactTrial(const ContactScene& scene, Real step, bool continuous)
    : response_(scene.response),
      continuous_(continuous),
      kernels_(scene.integrator.kernels),
      h_(step),
      model_(make_cloth_model(scene.cloth)),
      state_(make_rest_state(scene.cloth)),
      ball_(scene.ball),
      aim_(nearest_to_way(state_.x, scene.ball)),
      integrator_(make_integrator(scene.integrator, scene.cloth.particles)) {
    model_.gravity = scene.gravity;
    response_.displacement_share = displacement_share(scene.integrator.kind);
}

void ContactTrial::advance(BroadPhase& hierarchy) {
    before_ = state_.x;
    ball_.moved = h_ * ball_.velocity;
    ball_.centre += ball_.moved;
    const ClothInContact cloth = in_contact();
    const std::span balls(&ball_, 1);
    warm_start_.take(response_, h_, model_.gravity.norm(), std::span(&cloth, 1), contacts_);
    integrator_->step(model_, state_, h_);
    warm_start_.give(std::span(&cloth, 1), balls);
    hierarchy_ = &hierarchy;
    find();
    warm_start_.carry_over(response_, std::span(&cloth, 1), balls, contacts_);
}

void ContactTrial::find() {
    contacts_.clear();
    find_on_ball();
    passing_ = continuous_ && std::ranges::any_of(contacts_, &Contact::of_impact);
    if (!response_.ground.solid) return;
    find_ground_contacts(model_.grid, state_.x, response_.ground.height, response_.thickness, contacts_);
}

void ContactTrial::find_on_ball() {
    const Real thickness = response_.thickness;
    if (continuous_) {
        hierarchy_->build(before_, state_.x);
        hierarchy_->query(grown(way_of(ball_), thickness), candidates_);
    } else {
        hierarchy_->build(state_.x);
        hierarchy_->query(grown(ball_, thickness), candidates_);
    }
    std::ranges::sort(candidates_.cells);
    if (continuous_) {
        find_swept_contacts(model_.grid, before_, state_.x, ball_, 0, thickness, candidates_.cells, impacts_, contacts_,
                            kernels_);
        return;
    }
    find_contacts(model_.grid, state_.x, ball_, 0, thickness, candidates_.cells, contacts_, kernels_);
    find_node_contacts(model_.grid, state_.x, ball_, 0, thickness, node_push_speed * h_, candidates_.stopped,
                       contacts_);
}

ResponseReport ContactTrial::respond() {
    ResponseReport report = answer();
    if (response_.kind != ResponseKind::Projection) return report;
    for (int look = 0; look < most_looks && passing_; ++look) {
        contacts_.swap(first_contacts_);
        find();
        report = answer();
        contacts_.swap(first_contacts_);
    }
    return report;
}

ResponseReport ContactTrial::answer() {
    const ClothInContact cloth = in_contact();
    ContactRows* const rows = kernels_ == Kernels::Vector ? &rows_ : nullptr;
    return resolve_contacts(response_, h_, std::span(&cloth, 1), {}, std::span(&ball_, 1), {}, rows);
}

std::vector<int> ContactTrial::touched_triangles() const {
    const auto is_in_front = [&](const Vec3& normal) { return normal.dot(ball_.velocity) >= 0; };
    const SweptBall end{ball_.centre, ball_.centre, ball_.radius};
    std::vector<TriangleImpact> impacts;
    find_impacts(grid(), continuous_ ? before_ : state_.x, state_.x,
                 grown(continuous_ ? way_of(ball_) : end, response_.thickness), candidates_.cells, impacts);
    std::vector<int> triangles;
    for (const TriangleImpact& found : impacts) {
        if (is_in_front(found.impact.normal)) triangles.push_back(found.triangle);
    }
    for (const StoppedNode& node : candidates_.stopped) {
        const auto is_its = [&](const Contact& contact) {
            return contact.of_node && contact.triangle == 2 * node.cell && is_in_front(contact.normal);
        };
        if (std::ranges::any_of(contacts_, is_its)) add_triangles(grid(), node, triangles);
    }
    std::ranges::sort(triangles);
    return triangles;
}

bool ContactTrial::has_passed() const {
    return (state_.x.row(aim_).transpose() - ball_.centre).dot(ball_.velocity) < 0;
}

ContactHistory watch_contacts(const ContactScene& scene, const Detection& detection, Real step) {
    const auto hierarchy = make_broad_phase(detection.search, scene.cloth.particles);
    return watch_contacts(scene, *hierarchy, detection.continuous, step);
}

ContactHistory watch_contacts(const ContactScene& scene, BroadPhase& hierarchy, bool continuous, Real step) {
    ContactTrial trial(scene, step, continuous);
    SearchAudit audit(trial.grid(), scene.integrator.kernels);
    ContactHistory history;
    const auto deepen = [&](double& deepest) {
        const Real depth = audit.penetration(trial.positions(), std::span(&trial.ball(), 1), scene.response.thickness);
        deepest = std::max(deepest, static_cast<double>(depth));
    };
    const auto steps = std::llround(scene.end / static_cast<double>(step));
    for (std::int64_t k = 0; k < steps; ++k) {
        trial.advance(hierarchy);
        deepen(history.entered);
        history.touched.push_back(trial.touched_triangles());
        if (!trial.stopped().empty()) {
            const std::int64_t found =
                audit.false_contacts(trial.positions(), trial.ball(), scene.response.thickness, trial.stopped());
            history.false_contacts += static_cast<double>(found) / static_cast<double>(steps);
        }
        trial.respond();
        deepen(history.left);
    }
    history.passed = trial.has_passed();
    history.momentum = trial.model().particle_mass * trial.velocities().colwise().sum().transpose();
    return history;
}

ContactErrors compare_contacts(const ContactHistory& run, const ContactHistory& reference, int finer) {
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
    return {.missed_contacts = part(missed_contacts, contacts),
            .missed_steps = part(missed_steps, steps),
            .momentum = static_cast<double>((run.momentum - reference.momentum).norm() / reference.momentum.norm()),
            .passed = run.passed && !reference.passed};
}

}  // namespace drape
