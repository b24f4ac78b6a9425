#pragma once

#include "contact_batches.h"
#include "contact_solver.h"

namespace drape {

/// Whether no contact moves a second body, so that all of them depend on each other by particles alone.
inline bool has_fixed_bodies(const ContactProblem& problem) {
    const auto is_free = [](const Ball& ball) { return ball.inverse_mass > 0; };
    return problem.with_bodies && problem.pairs.empty() && problem.ball_contacts.empty() &&
           std::ranges::none_of(problem.balls, is_free);
}

/// Fills a lane with what `solve_contact` reads.
template <BodyMotion Motion>
void fill(const Motion& motion, const Contact& contact, const ContactPush& given, ContactBatches::Lane lane) {
    ContactBatch& batch = lane.batch;
    const auto set = [&](const Vec3& from, ContactBatch::Vectors& to) {
        for (std::size_t axis = 0; axis < 3; ++axis) to[axis][lane.number] = from[static_cast<Eigen::Index>(axis)];
    };
    set(contact.normal, batch.normal);
    set(motion.start(contact), batch.start);
    set(of_second(motion, contact), batch.body);
    set(given.friction, batch.friction);
    batch.push[lane.number] = given.normal;
    batch.target[lane.number] = given.target;
    batch.friction_coefficient[lane.number] = contact.friction_coefficient;
    batch.inverse_mass[lane.number] = contact.inverse_mass;
    batch.mass[lane.number] = contact.mass;
    batch.sliding_mass[lane.number] = contact.sliding_mass;
}

/// `sweep_until` of `solve_contact`, by vector.
template <BodyMotion Motion>
Sweeps solve_in_batches(ContactProblem& problem, Motion& motion, Real tolerance) {
    ContactBatches& batches = *problem.batches;
    batches.clear();
    for (std::size_t c = 0; c < problem.cloths.size(); ++c) {
        batches.begin_cloth(motion.of_cloth(static_cast<int>(c)));
        for (Contact& contact : problem.cloths[c].contacts) {
            if (!contact.takes_part) continue;
            ContactPush& given = Motion::given(contact);
            fill(motion, contact, given, batches.add(contact, given));
        }
    }
    Real square = 0;
    const int count = batches.solve(tolerance, most_sweeps, square);
    batches.give_back();
    return {count, std::sqrt(square)};
}

/// Solves the contacts that take part, one after the other, again and again.
template <BodyMotion Motion>
Sweeps solve_contacts(ContactProblem& problem, Motion& motion, Real tolerance) {
    if (problem.batches != nullptr && has_fixed_bodies(problem)) return solve_in_batches(problem, motion, tolerance);
    return sweep_until(problem, tolerance, [&](auto& contact) { return solve_contact(motion, contact); });
}

}  // namespace drape
