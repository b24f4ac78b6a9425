#pragma once

#include "drape/base/real.h"

/// The numbers of contact that were chosen, not derived: their unit, what they mean, and what happens beyond.
namespace drape {

// What is left, so that a resting contact lasts from substep to substep instead of flickering

/// The depth that is left at most [m]. More is seen; less, and contacts come and go.
inline constexpr Real max_slop = Real(3e-5);
/// In a ball less than this, of its radius; where ball meets ball, or a plane, of the radius too: a small ball is not
/// to be seen to sink in.
inline constexpr Real slop_of_radius = Real(1e-4), ball_slop_of_radius = Real(1e-3);

// When the sweeps end: with less the bits are about the same, with more what rests quivers

/// Tolerance of displacements, of what gravity moves a particle by within a step.
inline constexpr Real gravity_tolerance = Real(2e-3);
/// And where cloth meets cloth, of the thickness between them: many layers pass a push on slowly.
inline constexpr Real thickness_tolerance = Real(1e-3);
/// The tolerance of velocities where cloth meets cloth [m/s]: the whole cloth moves by a fifth of it, in the mean
/// square.
inline constexpr Real pair_velocity_tolerance = Real(1e-3);
/// At most this many sweeps. A cloth of a thousand contacts at rest needs ten to thirty.
inline constexpr int max_sweeps = 60;

// Projection

/// Rounds: a longer push shifts the closest points, and these have to be found again. With one, stretched triangles let
/// fast balls through.
inline constexpr int max_rounds = 4;
/// A push shorter than this fraction of the radius leaves a triangle's closest point where it is in the triangle.
inline constexpr Real short_push = Real(1e-3);
/// The least cosine between the normals at which something meets a body, for both to be of one side.
inline constexpr Real same_side = Real(0.5);
/// Of a particle's inverse mass, the least that a contact point may have, for a push to move no corner farther than
/// 1 / sqrt(0.05), some 4.5, times as far as the point.
inline constexpr Real min_mobility = Real(0.05);

// Motors

/// A motor is stopped by cloth that is stretched by this beyond its limit as the substep begins, of the rest length.
inline constexpr Real taut_stretch = Real(0.02);

/// A motor that is still taken back after so many sweeps is wedged.
inline constexpr int max_motor_sweeps = 8;

// What rests

/// An approach slower than this many steps of gravity is resting, and does not bounce.
inline constexpr Real resting_steps = 4;
/// What changes a speed by more than gravity does in this many steps is no rest, and is not given again: an impact, or
/// the way out of a ball that was put into the cloth.
inline constexpr Real rest_steps = 100;
/// By how many times its weight a ball that rests presses on a particle at most. One that is pressed on the ground, or
/// held by another contact, would fly off with more as soon as only one of both pushes goes on.
inline constexpr Real resting_weights = 3;
/// The fastest approach of what may rest under the hybrid, however long the substep is [m/s].
inline constexpr Real fastest_rest = Real(0.5);
/// Of a ball's radius, that cloth may come deep into it for a penalty of the hybrid to push it out. Deeper, it would
/// pass.
inline constexpr Real deep_part = Real(0.05);

// Solids

/// A triangle's own point counts where it is deeper than its corners by this [m]: on a flat side it is as deep.
inline constexpr Real deeper_than_corners = Real(1e-5);
/// How far a triangle is from a mesh is asked only so far between the limit of contact and its nearest corner: the
/// search is faster the less is asked, and the answer holds the longer the more.
inline constexpr Real clearance_asked = Real(0.5);
/// What a search for the deepest point may leave undone [m], and its steps.
inline constexpr Real deepest_tolerance = Real(1e-5);
inline constexpr int max_descents = 48;
/// A descent is given up where even so many times the slope gap would not bring it down to the limit. Once is a proof
/// for a convex distance; the rest is a margin on a mesh, where the slope proves nothing.
inline constexpr Real gap_margin = 2;

// Conservative advancement

/// What comes as near to a solid as this touches it, where it has no thickness, or is a ball [m].
inline constexpr Real touch_distance = Real(1e-6);
/// What still creeps after so many advances counts as a touch: that is early, never late.
inline constexpr int max_advances = 256;

// The fail-safe

/// Of the distance of two features at the start: nothing comes nearer than this, and what would come nearer than
/// somewhat more is stopped.
inline constexpr Real nearest_part = Real(0.1), margin_part = Real(0.1);

}  // namespace drape
