#include "drape/contact/response.h"

#include <algorithm>

#include "problem.h"

namespace drape {
namespace {

constexpr std::size_t max_reserved = 100'000;  // contacts

void follow_all(ContactProblem& problem) {
    for_each_row(problem, [&](ContactRow& row, const RowState&) { follow(problem, row); });
}

/// How a kind answers: impacts, where two sides meet faster than gravity alone brings them together within a few steps,
/// by impulses, or like all else; and all else by penalties, or by projection. Both impulses and penalties are the
/// hybrid of @cite constantinescu2005.
struct Answers {
    bool impulses, penalties;
};

/// In the order of the kinds.
constexpr std::array answers{Answers{false, false}, Answers{false, true}, Answers{true, false}, Answers{true, true}};
static_assert(answers.size() == enum_count<ResponseKind>, "every kind has its answers");

/// Whether something comes so deep into a ball that a penalty would let it pass.
bool has_deep_impact(const ContactProblem& problem) {
    bool any = false;
    for_each_row(problem, [&](const ContactRow& row, const RowState& state) {
        const bool of_surface = row.kind == RowKind::Particle || row.kind == RowKind::Triangle;
        if (!of_surface || !is_impact(problem, state) || !problem.body(row.body).is_ball()) return;
        any = any || row.depth > deep_part * problem.body(row.body).radius;
    });
    return any;
}

/// Answers the contacts of the response under way.
Sweeps respond_in_kind(ContactProblem& problem) {
    const Answers by = answers[static_cast<std::size_t>(problem.parameters.kind)];
    const bool projects = !by.penalties || (by.impulses && has_deep_impact(problem));
    const Sweeps impacts = by.impulses ? respond_by_impulses(problem) : Sweeps();
    if (projects) {
        if (impacts.count > 0) follow_all(problem);
        return impacts + respond_by_projection(problem);
    }
    choose(problem, [&](const ContactRow& row, const RowState& state) {
        return row.depth > 0 && !(by.impulses && is_impact(problem, state));
    });
    return impacts + respond_by_penalties(problem);
}

/// Pairs are always answered by projection: penalties of many pairs at one particle would add up, and an impulse is for
/// what meets, not for what is to keep apart. So is what stops a motor, which feels no force.
bool is_always_projected(const ContactProblem& problem, std::size_t row) {
    return problem.rows[row].kind == RowKind::Pair || problem.state(row).stops;
}

/// @return whether there are any
bool include(ContactProblem& problem, bool projected) {
    bool any = false;
    for (std::size_t r = 0; r < problem.rows.size(); ++r) {
        problem.state(r).included = is_always_projected(problem, r) == projected;
        any = any || problem.state(r).included;
    }
    return any;
}

Sweeps respond(ContactProblem& problem) {
    if (problem.parameters.kind == ResponseKind::Projection) return respond_in_kind(problem);
    include(problem, false);
    const Sweeps sweeps = respond_in_kind(problem);
    if (!include(problem, true)) return sweeps;
    follow_all(problem);
    return sweeps + respond_by_projection(problem);
}

}  // namespace

bool has_penalties(ResponseKind kind) { return answers[static_cast<std::size_t>(kind)].penalties; }

ContactSolver::Scratch& ContactSolver::scratch() {
    if (!scratch_) scratch_ = std::make_shared<Scratch>();
    return *scratch_;
}

void ContactSolver::reserve(std::size_t contacts) { scratch().states.reserve(std::min(contacts, max_reserved)); }

ResponseReport ContactSolver::resolve(const ResponseParameters& parameters, Real h,
                                      std::span<const ClothInContact> cloths, std::span<Body> bodies,
                                      std::span<ContactRow> rows) {
    if (rows.empty()) return {};
    ContactProblem problem{.parameters = parameters,
                           .h = h,
                           .gravity = cloths.front().model.gravity,
                           .cloths = cloths,
                           .bodies = bodies,
                           .rows = rows,
                           .scratch = scratch()};
    prepare(problem);
    const Sweeps sweeps = respond(problem);
    finish(problem);
    return {.depth = update_depths(cloths, bodies, rows), .residual = sweeps.residual, .sweeps = sweeps.count};
}

double work_of_kinematic_bodies(std::span<const ContactRow> rows, std::span<const Body> bodies) {
    Real work = 0;
    for (const ContactRow& row : rows) {
        if (row.body == no_body) continue;
        const Body& body = bodies[static_cast<std::size_t>(row.body)];
        if (body.inverse_mass == 0) work += row.impulse.about(row.normal).dot(body.velocity);
    }
    return static_cast<double>(work);
}

double kinetic_energy(std::span<const Body> bodies) {
    Real sum = 0;
    for (const Body& body : bodies) {
        if (body.inverse_mass == 0) continue;
        sum += body.velocity.squaredNorm() / body.inverse_mass + body.spin.squaredNorm() / body.inverse_inertia();
    }
    return static_cast<double>(sum / 2);
}

Real correction_of(const ContactRow& row, std::span<const Body> bodies) {
    Real slop = max_slop;
    const auto radius_of = [&](int body) {
        return body == no_body ? 0 : bodies[static_cast<std::size_t>(body)].radius;
    };
    if (radius_of(row.body) > 0) slop = std::min(slop, slop_of_radius * radius_of(row.body));
    if (row.first_body != no_body) slop = std::min(slop, ball_slop_of_radius * radius_of(row.first_body));
    return row.depth - slop;
}

__attribute__((flatten)) Real update_depths(std::span<const ClothInContact> cloths, std::span<const Body> bodies,
                                            std::span<ContactRow> rows) {
    Real deepest = 0;
    for (ContactRow& row : rows) {
        Vec3 offset = Vec3::Zero();
        for (const RowParticle& p : row.moved()) {
            offset += p.weight * position(cloths[static_cast<std::size_t>(p.cloth)].state.x, p.particle);
        }
        if (row.first_body != no_body) offset += bodies[static_cast<std::size_t>(row.first_body)].centre;
        if (row.body != no_body) offset -= bodies[static_cast<std::size_t>(row.body)].centre;
        row.depth = row.distance - row.normal.dot(offset);
        // Beside what stops a motor there is to be room for cloth
        if (row.kind != RowKind::Pair && !stops_motor(row, bodies)) deepest = std::max(deepest, row.depth);
    }
    return deepest;
}

}  // namespace drape
