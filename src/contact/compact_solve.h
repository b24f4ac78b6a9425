#pragma once

#include "contact_solver.h"
#include "drape/contact/contact_rows.h"
#include "kernels/row_sweeps.h"
#include "tuning.h"

namespace drape {

/// Whether no contact moves a second body, so that particles are all that contacts change.
inline bool has_fixed_bodies(const ContactProblem& problem) {
    const auto is_free = [](const Ball& ball) { return ball.inverse_mass > 0; };
    return problem.with_bodies && problem.pairs.empty() && problem.ball_contacts.empty() &&
           std::ranges::none_of(problem.balls, is_free);
}

/// Whenever the particles of contacts have changed; where contacts are not solved in rows, these are not used.
inline void order_rows(ContactProblem& problem) {
    if (!has_fixed_bodies(problem)) problem.rows = nullptr;
    if (problem.rows != nullptr) problem.rows->order(problem.cloths);
}

/// How the second body of a contact moves where it touches.
template <BodyMotion Motion>
Vec3 of_second(const Motion& motion, const Contact& contact) {
    return is_solid(contact.ball) ? motion.of_plane(contact.plane) : motion.of_ball(contact.ball, contact.normal);
}

inline Real4 four(const Vec3& v) { return {v[0], v[1], v[2], 0}; }

/// What `solve_contact` reads of a contact.
/// @param particles their places
/// @param offsets receives how many count, of this row and those before
template <BodyMotion Motion>
void fill_row(const Motion& motion, const Contact& contact, const std::array<int, 3>& particles, CompactContact& row,
              int& offsets) {
    const ContactPush& accumulated = Motion::accumulated(contact);
    const std::array<Vec3, 2> to_subtract{motion.start(contact), of_second(motion, contact)};
    row.normal = four(contact.normal);
    row.friction = four(accumulated.friction);
    row.push = accumulated.normal;
    row.target = accumulated.target;
    row.mass = contact.mass;
    row.sliding_mass = contact.sliding_mass;
    row.inverse_mass = contact.inverse_mass;
    row.friction_coefficient = contact.friction_coefficient;
    for (std::size_t k = 0; k < 3; ++k) {
        row.weights[k] = contact.particles[k].weight;
        row.shares[k] = contact.particles[k].share;
    }
    row.particles = particles;
    row.count = contact.particle_count;
    for (std::size_t k = 0; k < 2; ++k) {
        row.offsets[k] = four(to_subtract[k]);
        // To subtract zero changes no bit
        if (!to_subtract[k].isZero(0)) offsets = std::max(offsets, static_cast<int>(k) + 1);
    }
}

/// `sweep_until` of `solve_contact` over the contacts that were ordered, with the same bits.
template <BodyMotion Motion>
Sweeps solve_rows(ContactRows& rows, Motion& motion, Real tolerance) {
    rows.motion.clear();
    rows.offsets = 0;
    for (const auto [cloth, particle] : rows.particles) {
        rows.motion.push_back(four(position(motion.of_cloth(cloth), particle)));
    }
    if (rows.rows.size() < rows.contacts.size()) rows.rows.resize(rows.contacts.size());
    auto next = rows.rows.begin();
    for (const ContactRows::Ordered& ordered : rows.contacts) {
        if (!ordered.contact->active) continue;
        fill_row(motion, *ordered.contact, ordered.particles, *next++, rows.offsets);
    }
    const std::span solved(rows.rows.begin(), next);
    Sweeps sweeps;
    Real square = 0;
    do {
        square = kernels::sweep_rows(rows.motion, solved, rows.offsets);
        ++sweeps.count;
    } while (square > tolerance * tolerance && sweeps.count < max_sweeps);
    sweeps.residual = std::sqrt(square);

    auto moved = rows.motion.begin();
    for (const auto [cloth, particle] : rows.particles) {
        const auto [x, y, z, zero] = *moved++;
        motion.of_cloth(cloth).row(particle) << x, y, z;
    }
    auto row = solved.begin();
    for (const ContactRows::Ordered& ordered : rows.contacts) {
        if (!ordered.contact->active) continue;
        ContactPush& accumulated = Motion::accumulated(*ordered.contact);
        accumulated.normal = row->push;
        accumulated.friction = Vec3(row->friction[0], row->friction[1], row->friction[2]);
        ++row;
    }
    return sweeps;
}

/// Solves the contacts that take part, one after the other, again and again.
template <BodyMotion Motion>
Sweeps solve_contacts(ContactProblem& problem, Motion& motion, Real tolerance) {
    if (problem.rows != nullptr) return solve_rows(*problem.rows, motion, tolerance);
    // Flat, because GCC would call a function for each sum of three numbers
    const auto solve = [&](auto& contact) __attribute__((flatten)) { return solve_contact(motion, contact); };
    return sweep_until(problem, tolerance, solve);
}

}  // namespace drape
