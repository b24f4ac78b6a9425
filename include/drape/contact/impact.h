#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "drape/bounds/broad_phase.h"
#include "drape/bounds/swept_ball.h"

namespace drape {

/// The first touch of a moving ball and a moving triangle within a step.
struct Impact {
    Real time = 0;                      ///< in parts of the step, from 0 to 1
    std::array<Real, 3> barycentric{};  ///< of the triangle's point that touches, at that time
    Vec3 normal = Vec3::Zero();         ///< from the ball to the cloth at that time, length 1
};

/// The first time at which a ball and a triangle are no farther from each other than the ball's radius, while its
/// centre and the three corners move evenly on lines. @cite li2021
/// By conservative advancement: seen from the ball's centre, the triangle is beyond the plane through its closest
/// point, and cannot touch until a corner has come through a parallel plane beside the ball. Any triangle will do, one
/// without area too. A touch that is nowhere deeper than 1e-5 of the radius may be missed.
/// @param ball grown by the cloth's thickness
/// @param from, to the corners at the step's beginning and end [m]
/// @return none if they do not touch; time 0 if they touch already
/// @par Cost some distances to a triangle; a few comparisons where the boxes about both stay apart; no heap
std::optional<Impact> first_impact(const SweptBall& ball, const std::array<Vec3, 3>& from,
                                   const std::array<Vec3, 3>& to);

/// A triangle of the cloth and its first touch with a swept ball.
struct TriangleImpact {
    int triangle = 0;
    std::array<int, 3> corners{};  ///< its particles
    Impact impact;
};

/// The first touches of the candidate cells' triangles with one swept ball, appended in the order of the cells. With
/// all cells it is its own oracle.
/// @param from, to positions at the step's beginning and end, n x 3 [m]
/// @param ball grown by the cloth's thickness
/// @par Cost O(cells); cells whose boxes the ball does not pass cost some comparisons
void find_impacts(const Grid& grid, const Points& from, const Points& to, const SweptBall& ball,
                  std::span<const CellRun> cells, std::vector<TriangleImpact>& impacts);

}  // namespace drape
