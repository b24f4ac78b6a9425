#include "drape/contact/warm_start.h"

#include <algorithm>

#include "contact/pairs/pair_tests.h"
#include "drape/contact/closest_point.h"
#include "mobility.h"

namespace drape {
namespace {

/// A contact, and by what inverse mass an impulse meets each of its sides.
struct Sides {
    Real of_particles, of_body;

    Sides(std::span<const ClothInContact> cloths, std::span<const Body> bodies, const ContactRow& row)
        : of_particles(mobility_of(cloths, row).inverse_mass),
          of_body(row.body == no_body ? 0 : bodies[static_cast<std::size_t>(row.body)].inverse_mass) {}

    /// Of the heavier side, of those that can move.
    [[nodiscard]] Real min_inverse_mass() const {
        return moves_both() ? std::min(of_particles, of_body) : of_particles + of_body;
    }

    /// Whether it pushes a free ball too. Such a contact is kept without impulses, to be told that it lasts.
    [[nodiscard]] bool moves_both() const { return of_particles > 0 && of_body > 0; }
};

/// Whether a contact pushes no harder than what rests does. Cloth that carries a ball is pushed by many times its own
/// weight, but so it is by an impact: the ball's weight counts where the contact was there in the substep before.
/// @param impulse along its normal [kg m/s]
/// @param in_a_step by what gravity changes a speed in its substep [m/s]
bool may_rest(const ContactRow& row, const Sides& sides, Real impulse, Real in_a_step) {
    if (impulse * (sides.of_particles + sides.of_body) <= rest_steps * in_a_step) return true;
    return row.lasts && impulse * sides.min_inverse_mass() <= resting_weights * in_a_step;
}

RowImpulse scaled(const RowImpulse& impulse, Real factor) {
    return {factor * impulse.normal, factor * impulse.friction};
}

/// Whether the response may go on from a contact. Those of nodes and of bodies are found anew, and what was carried
/// over without being found is kept for one substep alone.
bool goes_on(const ResponseParameters& parameters, const ContactRow& row) {
    if (row.kind == RowKind::Node || row.kind == RowKind::Bodies || row.separated) return false;
    if (row.kind == RowKind::Pair) return row.displacement.normal != 0;
    if (parameters.kind == ResponseKind::Penalty) return false;
    return (parameters.kind == ResponseKind::Hybrid ? row.impulse : row.displacement).normal != 0;
}

/// Where a contact of before is now. Its plane stays, for the ball may have come through the cloth since; that of a
/// pair is of this substep's start.
void follow_from_before(std::span<const ClothInContact> cloths, std::span<const Body> bodies, ContactRow& row) {
    if (row.kind == RowKind::Pair) {
        NearPair pair = pair_of(row);
        const auto at = [&](int number) -> ClothAt {
            const ClothInContact& cloth = cloths[static_cast<std::size_t>(number)];
            return {number, cloth.model.grid, cloth.before};
        };
        locate(at(pair.features.cloths[0]), at(pair.features.cloths[1]), pair);
        if (pair.distance > 0) set_plane(pair, row);
    } else {
        row.separated = true;
    }
    update_depths(cloths, bodies, {&row, 1});
}

}  // namespace

void WarmStart::take(const ResponseParameters& parameters, Real h, Real gravity, std::span<const ClothInContact> cloths,
                     std::span<const Body> bodies, std::vector<ContactRow>& rows) {
    const Real h_before = h_ > 0 ? h_ : h, factor = h / h_before, displaces = parameters.displacement_factor;
    h_ = h;
    last_.clear();
    for (ContactRow& row : rows) {
        if (!goes_on(parameters, row)) continue;
        const Sides sides(cloths, bodies, row);
        const auto rests = [&](Real impulse) { return may_rest(row, sides, impulse, h_before * gravity); };
        const bool rested = rests(row.displacement.normal / (displaces * h_before));
        const bool solved = row.kind == RowKind::Pair || parameters.kind != ResponseKind::Hybrid;
        if (solved && !rested && !sides.moves_both()) continue;
        const bool stopped_gently = rests(row.impulse.normal);
        row.displacement = scaled(row.displacement, solved && rested ? factor * factor : Real(0));
        row.impulse = scaled(row.impulse, solved && rested && stopped_gently ? displaces * factor : Real(0));
        last_.push_back(row);
    }
    rows.clear();
}

/// Flat, because GCC would call a function for each sum of three numbers.
__attribute__((flatten)) void WarmStart::give(std::span<const ClothInContact> cloths, std::span<Body> bodies) const {
    for (const ContactRow& row : last_) {
        if (!row.has_impulse()) continue;
        const Vec3 displacement = row.displacement.about(row.normal), impulse = row.impulse.about(row.normal);
        const std::array<Real, 4> mobilities = mobility_of(cloths, row).of_particles;
        for (std::size_t k = 0; k < row.count; ++k) {
            const auto [cloth, particle, weight] = row.particles[k];
            ClothState& state = cloths[static_cast<std::size_t>(cloth)].state;
            state.x.row(particle) += mobilities[k] * displacement.transpose();
            state.v.row(particle) += mobilities[k] * impulse.transpose();
        }
        if (row.body == no_body) continue;
        Body& body = bodies[static_cast<std::size_t>(row.body)];
        if (body.inverse_mass == 0) continue;
        const Vec3 arm = body.arm(row.normal);
        body.moved -= body.inverse_mass * displacement;
        body.centre -= body.inverse_mass * displacement;
        body.turned -= body.inverse_inertia() * arm.cross(displacement);
        body.velocity -= body.inverse_mass * impulse;
        body.spin -= body.inverse_inertia() * arm.cross(impulse);
    }
}

double WarmStart::work(std::span<const ClothInContact> cloths, int cloth) const {
    const ClothInContact& of = cloths[static_cast<std::size_t>(cloth)];
    Real work = 0;
    for (const ContactRow& row : last_) {
        if (row.impulse.normal == 0) continue;
        const Vec3 force = row.impulse.about(row.normal) / h_;
        for (const RowParticle& p : row.moved()) {
            if (p.cloth != cloth || of.inverse_mass(p.particle) == 0) continue;
            work += p.weight * force.dot(position(of.state.x, p.particle) - position(of.before, p.particle));
        }
    }
    return static_cast<double>(work);
}

void WarmStart::carry_over(std::span<const ClothInContact> cloths, std::span<const Body> bodies,
                           std::vector<ContactRow>& rows) {
    merged_.clear();
    auto found = rows.begin();
    for (const ContactRow& before : last_) {
        while (found != rows.end() && compare(*found, before) < 0) merged_.push_back(*found++);
        if (found != rows.end() && compare(*found, before) == 0) {
            merged_.push_back(*found++);
            merged_.back().displacement = before.displacement;
            merged_.back().impulse = before.impulse;
            merged_.back().lasts = true;
        } else if (before.displacement.normal > 0) {
            merged_.push_back(before);
            follow_from_before(cloths, bodies, merged_.back());
        }
    }
    merged_.insert(merged_.end(), found, rows.end());
    rows.swap(static_cast<std::vector<ContactRow>&>(merged_));
}

}  // namespace drape
