#include "drape/contact/response.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "contact_geometry.h"

namespace drape {
namespace {

/// Depth that is left in place, over the radius: a resting contact then lasts from step to step instead of flickering.
constexpr Real slop = Real(1e-4);

/// Sweeps over the contacts. Positions stop earlier once no contact had to be corrected.
constexpr int position_sweeps = 6;
constexpr int velocity_sweeps = 2;

/// An approach slower than this many steps of gravity is resting, and does not bounce.
constexpr Real resting_steps = 4;

/// The three particles of a contact with their weights, and the inverse mass that a push at the contact point meets.
struct Lever {
    std::array<int, 3> corners;
    std::array<Real, 3> weights;
    std::array<Real, 3> inverse_masses{};
    Real inverse_mass = 0;  ///< sum of w^2/m; zero if nothing can move
};

Lever lever_of(const ClothModel& model, const Contact& contact) {
    Lever lever{.corners = model.grid.triangle_corners(contact.triangle), .weights = contact.barycentric};
    for (std::size_t k = 0; k < 3; ++k) {
        lever.inverse_masses[k] = model.inverse_mass[lever.corners[k]];
        lever.inverse_mass += lever.weights[k] * lever.weights[k] * lever.inverse_masses[k];
    }
    return lever;
}

/// Moves (or speeds up) the particles so that the contact point moves by `change` [m or m/s].
void push(const Lever& lever, const Vec3& change, Points& p) {
    for (std::size_t k = 0; k < 3; ++k) {
        const Real share = lever.weights[k] * lever.inverse_masses[k] / lever.inverse_mass;
        p.row(lever.corners[k]) += share * change.transpose();
    }
}

Vec3 velocity_at(const Lever& lever, const Points& v) {
    return lever.weights[0] * position(v, lever.corners[0]) + lever.weights[1] * position(v, lever.corners[1]) +
           lever.weights[2] * position(v, lever.corners[2]);
}

/// Pushes every contact out along its normal; its neighbours see the moved particles.
void separate(const ClothModel& model, const ResponseParameters& parameters, std::span<const Ball> balls,
              std::vector<Contact>& contacts, Points& x) {
    bool moved = false;  // contacts are fresh until the first particle moves
    bool corrected = true;
    for (int sweep = 0; sweep < position_sweeps && corrected; ++sweep) {
        corrected = false;
        for (Contact& contact : contacts) {
            const Ball& ball = balls[static_cast<std::size_t>(contact.ball)];
            if (moved) locate(model.grid, x, ball, parameters.thickness, contact);
            const Real excess = contact.depth - slop * ball.radius;
            if (excess <= 0) continue;
            const Lever lever = lever_of(model, contact);
            if (lever.inverse_mass == 0) continue;
            push(lever, excess * contact.normal, x);
            corrected = moved = true;
        }
    }

    // The last sweep's pushes are not in the depths yet
    if (!corrected) return;
    for (Contact& contact : contacts) {
        locate(model.grid, x, balls[static_cast<std::size_t>(contact.ball)], parameters.thickness, contact);
    }
}

/// Stops every contact point that approaches its ball, or throws it back.
void stop_approach(const ClothModel& model, const ResponseParameters& parameters, std::span<const Ball> balls, Real h,
                   std::vector<Contact>& contacts, Points& v) {
    const Real resting = resting_steps * h * model.gravity.norm();
    for (int sweep = 0; sweep < velocity_sweeps; ++sweep) {
        for (Contact& contact : contacts) {
            const Lever lever = lever_of(model, contact);
            if (lever.inverse_mass == 0) continue;
            const Vec3& ball_velocity = balls[static_cast<std::size_t>(contact.ball)].velocity;
            const Real approach = -(velocity_at(lever, v) - ball_velocity).dot(contact.normal);
            if (approach <= 0) continue;
            const Real bounce = sweep == 0 && approach > resting ? parameters.restitution : Real(0);
            const Real change = (1 + bounce) * approach;
            push(lever, change * contact.normal, v);
            contact.impulse += change / lever.inverse_mass;
        }
    }
}

/// Slows the sliding of every contact by at most the friction coefficient times its normal impulse.
void slow_sliding(const ClothModel& model, const ResponseParameters& parameters, std::span<const Ball> balls,
                  std::vector<Contact>& contacts, Points& v) {
    for (const Contact& contact : contacts) {
        if (contact.impulse <= 0) continue;
        const Lever lever = lever_of(model, contact);
        const Vec3 relative = velocity_at(lever, v) - balls[static_cast<std::size_t>(contact.ball)].velocity;
        const Vec3 sliding = relative - relative.dot(contact.normal) * contact.normal;
        const Real speed = sliding.norm();
        if (speed == 0) continue;
        const Real change = std::min(speed, parameters.friction * contact.impulse * lever.inverse_mass);
        push(lever, -(change / speed) * sliding, v);
    }
}

}  // namespace

Real resolve_contacts(const ClothModel& model, const ResponseParameters& parameters, std::span<const Ball> balls,
                      Real h, std::vector<Contact>& contacts, ClothState& state) {
    separate(model, parameters, balls, contacts, state.x);
    stop_approach(model, parameters, balls, h, contacts, state.v);
    slow_sliding(model, parameters, balls, contacts, state.v);

    Real deepest = 0;
    for (const Contact& contact : contacts) deepest = std::max(deepest, contact.depth);
    return deepest;
}

std::span<const std::string> response_names() {
    static const std::array<std::string, 1> names{"projection"};
    return names;
}

}  // namespace drape
