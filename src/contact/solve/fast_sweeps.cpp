#include "problem.h"

#include <utility>

#include "drape/base/assert.h"

namespace drape {
namespace {

/// By how many particles a contact has: four, three or one.
constexpr std::size_t groups_of_level = 3;

std::size_t group_in_level(const ContactRow& row) { return row.count == 4 ? 0 : row.count == 3 ? 1 : 2; }

Real4 four(const Vec3& v) { return {v[0], v[1], v[2], 0}; }

/// What `solve` reads of a contact.
void fill(const ContactProblem& problem, const ContactMotion& motion, ContactRow& row, RowState& state,
          CompactRow& compact) {
    DRAPE_ASSERT(row.count == 1 || row.count == 3 || row.count == 4);
    const RowImpulse& total = accumulated(row, motion.quantity);
    compact.normal = four(row.normal);
    compact.friction = four(total.friction);
    compact.impulse = total.normal;
    compact.target = target_of(state, motion.quantity);
    compact.mass = state.mass;
    compact.sliding_mass = state.sliding_mass;
    compact.inverse_mass = state.inverse_mass;
    compact.friction_coefficient = state.surface.friction;
    for (std::size_t k = 0; k < 4; ++k) compact.weights[k] = row.particles[k].weight;
    compact.mobilities = state.mobilities;
    compact.places = state.places;
    compact.count = row.count;
    // To subtract zero changes no bit
    compact.offsets = {};
    if (motion.quantity == Quantity::Displacement) compact.offsets[0] = four(state.start);
    if (row.body != no_body) compact.offsets[1] = four(motion_of_body(problem, motion, row.body, row.normal));
}

bool pushes_no_body(const ContactProblem& problem) {
    return std::ranges::all_of(problem.bodies, [](const Body& body) { return body.inverse_mass == 0; });
}

/// Calls visit(row, state) for the chosen contacts, in the order of solves over compact rows.
template <class Visit>
void for_each_ordered(const ContactProblem& problem, Visit visit) {
    for (const int number : problem.scratch.order) {
        const auto r = static_cast<std::size_t>(number);
        if (problem.state(r).included && problem.state(r).active) visit(problem.rows[r], problem.state(r));
    }
}

}  // namespace

/// A contact is one level above the highest of those before it that share a particle with it; they come level by level,
/// in each those that have more particles first.
void order_rows(ContactProblem& problem) {
    auto& [states, particles, place_of, displacements, velocities, order, compact, levels, groups, next_of] =
        problem.scratch;
    order.clear();
    if (problem.parameters.kernels == Kernels::Plain || !pushes_no_body(problem)) return;
    levels.assign(particles.size(), 0);
    groups.clear();
    next_of.clear();
    for (std::size_t r = 0; r < problem.rows.size(); ++r) {
        const auto places = std::span(states[r].places).first(problem.rows[r].count);
        std::size_t level = 0;
        for (const int place : places) level = std::max(level, levels[static_cast<std::size_t>(place)]);
        for (const int place : places) levels[static_cast<std::size_t>(place)] = level + 1;
        groups.push_back(groups_of_level * level + group_in_level(problem.rows[r]));
        if (groups.back() >= next_of.size()) next_of.resize(groups_of_level * (level + 1));
        ++next_of[groups.back()];
    }
    std::size_t next = 0;
    for (std::size_t& first : next_of) next += std::exchange(first, next);
    order.resize(problem.rows.size());
    for (std::size_t r = 0; r < groups.size(); ++r) order[next_of[groups[r]]++] = static_cast<int>(r);
}

Sweeps solve_compact(ContactProblem& problem, ContactMotion& motion, Real tolerance) {
    std::vector<CompactRow>& compact = problem.scratch.compact;
    compact.resize(std::max(compact.size(), problem.rows.size()));
    auto next = compact.begin();
    for_each_ordered(problem, [&](ContactRow& row, RowState& state) { fill(problem, motion, row, state, *next++); });
    const std::span solved(compact.begin(), next);
    const Sweeps sweeps = sweep_until(tolerance, [&] { return kernels::sweep_rows(motion.particles, solved); });
    auto row_solved = solved.begin();
    for_each_ordered(problem, [&](ContactRow& row, RowState&) {
        const auto& [x, y, z, zero] = row_solved->friction;
        accumulated(row, motion.quantity) = {row_solved->impulse, Vec3(x, y, z)};
        ++row_solved;
    });
    return sweeps;
}

}  // namespace drape
