#include <algorithm>
#include <limits>

#include "drape/contact/detection.h"
#include "drape/model/stencils.h"
#include "drape/sim/simulation.h"

namespace drape {
namespace {

/// What can stop a ball under the keys, which nothing pushes.
struct BallStops {
    std::span<const Cloth> cloths;
    std::span<const ContactRow> rows;  ///< contacts of the substep before
    std::span<const Body> bodies;      ///< solids, and the ground if it is solid
    Real thickness;                    ///< of the cloth: a pin has it, and bodies leave room for two [m]
};

/// By how much of its rest length a spring is beyond the limit where cloth counts as taut. Contact, which comes after
/// the limit, leaves less in cloth that can give way, but for what the ball has just moved by.
constexpr Real taut = Real(0.02);

/// A ball that is not free of everything after so many rounds is wedged.
constexpr int max_rounds = 8;

/// Of a length that was computed from others.
constexpr Real length_rounding = 16 * std::numeric_limits<Real>::epsilon();

/// Moves a ball back along a normal, and takes its velocity along it.
void take_back(const Vec3& normal, Real length, Ball& ball) {
    ball.centre -= length * normal;
    ball.moved -= length * normal;
    ball.velocity -= std::max(normal.dot(ball.velocity), Real(0)) * normal;
}

/// Whether a contact is one of a ball with cloth that has a stretch limit; without one, it always gives way.
bool may_stop(const BallStops& stops, int number, const ContactRow& row) {
    return row.kind != RowKind::Bodies && row.body == number &&
           stops.cloths[static_cast<std::size_t>(row.particles[0].cloth)].model.stretch_limit > 0;
}

/// Whether a structural spring at the particles of a contact is taut.
/// @param drawn by the ball within the substep [m]
bool is_taut_at(const Cloth& cloth, const ContactRow& row, Real drawn) {
    const ClothModel& model = cloth.model;
    return std::ranges::any_of(row.moved(), [&](const RowParticle& p) {
        bool found = false;
        for_each_spring_at(model, p.particle, [&](const SpringStencil& springs, int other) {
            const Real longest = (1 + model.stretch_limit + taut) * springs.rest_length + drawn;
            const Vec3 d = cloth.state.x.row(p.particle) - cloth.state.x.row(other);
            found = found || (springs.structural() && d.squaredNorm() > longest * longest);
        });
        return found;
    });
}

bool touches_taut_cloth(const BallStops& stops, int number, Real drawn) {
    return std::ranges::any_of(stops.rows, [&](const ContactRow& row) {
        return may_stop(stops, number, row) &&
               is_taut_at(stops.cloths[static_cast<std::size_t>(row.particles[0].cloth)], row, drawn);
    });
}

/// @return whether it had to be stopped
bool stop_at_contacts(const BallStops& stops, int number, Real rounding, Ball& ball) {
    bool stopped = false;
    for (const ContactRow& row : stops.rows) {
        const Real towards = row.normal.dot(ball.moved);
        if (!may_stop(stops, number, row) || !(towards > rounding)) continue;
        take_back(row.normal, towards, ball);
        stopped = true;
    }
    return stopped;
}

/// Calls visit(offset, depth) for each pin that a ball has come too near to, with the pin's offset from its centre; one
/// that was in the ball at the start may not come nearer to its centre.
/// @param start of the ball's centre [m]
/// @param ball may be moved by visit; then the pins that follow see it there
template <class Visit>
void for_each_pin_in(const BallStops& stops, const Vec3& start, const Ball& ball, Visit visit) {
    for (const Cloth& cloth : stops.cloths) {
        for (int p = 0; p < cloth.model.grid.particles(); ++p) {
            if (!cloth.model.pinned(p) || p == cloth.grabbed) continue;
            const Vec3 pin = cloth.state.x.row(p).transpose(), offset = pin - ball.centre;
            const Real distance = offset.norm(), least = std::min(ball.radius + stops.thickness, (pin - start).norm());
            const Real rounding = length_rounding * (pin.cwiseAbs().sum() + least);
            if (distance < least - rounding) visit(offset, least - distance);
        }
    }
}

/// @param start of the ball's centre [m]
/// @return whether it had to be stopped
bool stop_at_pins(const BallStops& stops, const Vec3& start, Ball& ball) {
    bool stopped = false;
    for_each_pin_in(stops, start, ball, [&](const Vec3& offset, Real depth) {
        if (offset.isZero(0)) return;
        take_back(offset.normalized(), depth, ball);
        stopped = true;
    });
    return stopped;
}

/// Whether a wedged ball may go where it is led because it penetrates nothing more deeply there.
bool may_leave(const BallStops& stops, const Ball& led) {
    bool enters_pin = false;
    for_each_pin_in(stops, led.centre - led.moved, led, [&](const Vec3&, Real) { enters_pin = true; });
    return !enters_pin && penetrates_no_deeper(stops.bodies, 2 * stops.thickness, led);
}

/// Stops a ball within the substep. It may slide along what stops it, and go back.
/// - Cloth stops it while a spring where they touch is well beyond the cloth's stretch limit: pins, the hand, or what
///   presses from the other side then leave it no more to give. Cloth without a limit always gives way.
/// - So does a pinned particle, unless it is in the hand, which gives way; one that is inside the ball already may come
///   no nearer to its centre. Where the ball is at the end of the substep counts, not what it has passed.
/// - So do ground and solids.
///
/// A ball that cannot get out of all of these stays where it was, unless the keys lead it where it penetrates none of
/// them more deeply. A ball at rest gives way to solids that move into it, if the ground leaves it room; cloth and pins
/// do not stop it then.
/// @param number of the ball, which has moved within the substep
/// @par Cost O(particles) where the ball moves
void stop_ball(const BallStops& stops, int number, Ball& ball) {
    const Real room = 2 * stops.thickness;
    const Vec3 start = ball.centre - ball.moved;
    if (ball.moved.isZero(0)) {
        stay_outside(stops.bodies, start, room, ball);
        return;
    }
    const Ball led = ball;
    const Real moved = ball.moved.norm(), rounding = length_rounding * moved;
    const bool is_taut = touches_taut_cloth(stops, number, moved);
    for (int round = 0; round < max_rounds; ++round) {
        bool stopped = is_taut && stop_at_contacts(stops, number, rounding, ball);
        stopped = stop_at_pins(stops, start, ball) || stopped;
        stopped = stay_outside(stops.bodies, start, room, ball) || stopped;
        if (!stopped) return;
    }
    Ball probe = led;
    const bool into_taut = is_taut && stop_at_contacts(stops, number, rounding, probe);
    if (!into_taut && may_leave(stops, led)) {
        ball = led;
        return;
    }
    ball.centre = start;
    ball.velocity.setZero();
    ball.moved.setZero();
}

}  // namespace

void Simulation::stop_balls() {
    obstacles_.clear();
    for (const Solid& solid : solids_) obstacles_.push_back(body_of(solid, {}));
    if (settings_.ground.solid) obstacles_.push_back(body_of(settings_.ground));
    const BallStops stops{cloths_, contact_.rows(), obstacles_, settings_.contact.thickness};
    for (std::size_t b = 0; b < balls_.size(); ++b) {
        if (settings_.balls[b].motion == BallMotion::Keys) stop_ball(stops, static_cast<int>(b), balls_[b]);
    }
}

}  // namespace drape
