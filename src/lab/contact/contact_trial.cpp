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

/// The triangles in contact with the front of the ball, and all of a node whose sphere is.
std::vector<int> touched_triangles(const ContactTrial& trial) {
    std::vector<int> triangles;
    const auto is_in_front = [&](const Contact& contact) { return contact.normal.dot(trial.ball().velocity) >= 0; };
    for (const Contact& contact : trial.contacts()) {
        if (!contact.of_node && is_in_front(contact)) triangles.push_back(contact.triangle);
    }
    for (const StoppedNode& node : trial.stopped()) {
        const auto is_its = [&](const Contact& contact) {
            return contact.of_node && contact.triangle == 2 * node.cell && is_in_front(contact);
        };
        if (std::ranges::none_of(trial.contacts(), is_its)) continue;
        for (int j = node.j0; j < node.j1; ++j) {
            for (int i = node.i0; i < node.i1; ++i) {
                const int cell = j * trial.grid().cell_columns() + i;
                triangles.push_back(2 * cell);
                triangles.push_back(2 * cell + 1);
            }
        }
    }
    std::ranges::sort(triangles);
    return triangles;
}

}  // namespace

ContactTrial::ContactTrial(const ContactScene& scene, Real step)
    : response_(scene.response),
      kernels_(scene.integrator.kernels),
      h_(step),
      model_(make_cloth_model(scene.cloth)),
      state_(make_rest_state(scene.cloth)),
      ball_(scene.ball),
      aim_(nearest_to_way(state_.x, scene.ball)),
      integrator_(make_integrator(scene.integrator, scene.cloth.particles)) {
    response_.integrator = scene.integrator.kind;
}

void ContactTrial::advance(BroadPhase& hierarchy) {
    before_ = state_.x;
    ball_.moved = h_ * ball_.velocity;
    ball_.centre += ball_.moved;
    const ClothInContact cloth = in_contact();
    const std::span balls(&ball_, 1);
    warm_start_.take(response_, h_, model_.gravity.norm(), contacts_);
    warm_start_.before_step(std::span(&cloth, 1), balls);
    integrator_->step(model_, state_, h_);
    warm_start_.after_step(std::span(&cloth, 1), balls);
    hierarchy.build(state_.x);
    hierarchy.query(grown(ball_, response_.thickness), candidates_);
    std::ranges::sort(candidates_.cells);
    contacts_.clear();
    find_contacts(model_.grid, state_.x, ball_, 0, response_.thickness, candidates_.cells, contacts_, kernels_);
    find_node_contacts(model_.grid, state_.x, ball_, 0, response_.thickness, node_push_speed * h_, candidates_.stopped,
                       contacts_);
    warm_start_.carry_over(response_, std::span(&cloth, 1), balls, contacts_);
}

void ContactTrial::respond() {
    const ClothInContact cloth = in_contact();
    resolve_contacts(response_, h_, std::span(&cloth, 1), {}, std::span(&ball_, 1), {});
}

bool ContactTrial::has_passed() const {
    return (state_.x.row(aim_).transpose() - ball_.centre).dot(ball_.velocity) < 0;
}

ContactHistory watch_contacts(const ContactScene& scene, const BroadPhaseParameters& search, Real step) {
    const auto hierarchy = make_broad_phase(search, scene.cloth.particles);
    return watch_contacts(scene, *hierarchy, step);
}

ContactHistory watch_contacts(const ContactScene& scene, BroadPhase& hierarchy, Real step) {
    ContactTrial trial(scene, step);
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
        history.touched.push_back(touched_triangles(trial));
        if (!trial.stopped().empty()) {
            const std::int64_t found =
                audit.false_contacts(trial.positions(), trial.ball(), scene.response.thickness, trial.stopped());
            history.false_contacts += static_cast<double>(found) / static_cast<double>(steps);
        }
        trial.respond();
        deepen(history.left);
    }
    history.passed = trial.has_passed();
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
            .passed = run.passed && !reference.passed};
}

}  // namespace drape
