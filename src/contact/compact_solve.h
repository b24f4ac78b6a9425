#pragma once

#include "contact_solver.h"
#include "drape/contact/contact_rows.h"
#include "kernels/row_sweeps.h"

namespace drape {

/// Whether no contact moves a second body, so that particles are all that contacts change.
inline bool has_fixed_bodies(const ContactProblem& problem) {
    const auto is_free = [](const Ball& ball) { return ball.inverse_mass > 0; };
    return problem.with_bodies && problem.pairs.empty() && problem.ball_contacts.empty() &&
           std::ranges::none_of(problem.balls, is_free);
}

/// How the second body of a contact moves where it touches.
template <BodyMotion Motion>
Vec3 of_second(const Motion& motion, const Contact& contact) {
    return is_solid(contact.ball) ? motion.of_plane(contact.plane) : motion.of_ball(contact.ball, contact.normal);
}

/// What `solve_contact` reads of a contact.
/// @param offsets receives how many count, of this row and those before
template <BodyMotion Motion>
void fill_row(const Motion& motion, const Contact& contact, const ContactPush& given, CompactContact& row,
              int& offsets) {
    row.normal = contact.normal;
    row.friction = given.friction;
    row.offsets = {motion.start(contact), of_second(motion, contact)};
    row.push = given.normal;
    row.target = given.target;
    row.mass = contact.mass;
    row.sliding_mass = contact.sliding_mass;
    row.inverse_mass = contact.inverse_mass;
    row.friction_coefficient = contact.friction_coefficient;
    row.count = contact.particle_count;
    for (std::size_t k = 0; k < 3; ++k) {
        row.weights[k] = contact.particles[k].weight;
        row.shares[k] = contact.particles[k].share;
        row.particles[k] = contact.particles[k].particle;
    }
    // To subtract zero changes no bit
    for (int k = offsets; k < 2; ++k) {
        if (!row.offsets[static_cast<std::size_t>(k)].isZero(0)) offsets = k + 1;
    }
}

/// `sweep_until` of `solve_contact`, with the same bits.
template <BodyMotion Motion>
Sweeps solve_rows(ContactProblem& problem, Motion& motion, Real tolerance) {
    ContactRows& rows = *problem.rows;
    rows.clear();
    for (std::size_t c = 0; c < problem.cloths.size(); ++c) {
        Points& of_cloth = motion.of_cloth(static_cast<int>(c));
        std::vector<Contact>& contacts = problem.cloths[c].contacts;
        const std::size_t first = rows.places.size();
        rows.add_places(contacts, of_cloth.rows());
        if (rows.rows.size() < rows.places.size()) rows.rows.resize(rows.places.size());
        auto place = rows.places.begin() + static_cast<std::ptrdiff_t>(first);
        for (Contact& contact : contacts) {
            if (!contact.takes_part) continue;
            fill_row(motion, contact, Motion::given(contact), rows.rows[*place++], rows.offsets);
        }
        rows.cloths.push_back({of_cloth.data(), of_cloth.rows(), first, rows.places.size()});
    }
    Sweeps sweeps;
    Real square = 0;
    do {
        square = 0;
        for (const ClothRows& cloth : rows.cloths) {
            const auto of_cloth = std::span(rows.rows).subspan(cloth.first, cloth.end - cloth.first);
            square = std::max(square, kernels::sweep_rows(cloth, of_cloth, rows.offsets));
        }
        ++sweeps.count;
    } while (square > tolerance * tolerance && sweeps.count < most_sweeps);
    sweeps.residual = std::sqrt(square);

    auto place = rows.places.begin();
    for (const ClothInContact& cloth : problem.cloths) {
        for (Contact& contact : cloth.contacts) {
            if (!contact.takes_part) continue;
            const CompactContact& row = rows.rows[*place++];
            Motion::given(contact).normal = row.push;
            Motion::given(contact).friction = row.friction;
        }
    }
    return sweeps;
}

/// Solves the contacts that take part, one after the other, again and again.
template <BodyMotion Motion>
Sweeps solve_contacts(ContactProblem& problem, Motion& motion, Real tolerance) {
    if (problem.rows != nullptr && has_fixed_bodies(problem)) return solve_rows(problem, motion, tolerance);
    // Flat, for GCC would call a function for each sum of three numbers
    const auto solve = [&](auto& contact) __attribute__((flatten)) { return solve_contact(motion, contact); };
    return sweep_until(problem, tolerance, solve);
}

}  // namespace drape
