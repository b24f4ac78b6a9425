#pragma once

#include <array>
#include <span>
#include <vector>

#include "drape/bounds/broad_phase.h"
#include "drape/model/ball.h"
#include "drape/model/cloth_model.h"

namespace drape {

/// A triangle of the cloth nearer to a ball than the cloth's thickness, or a node of the hierarchy that stands for the
/// cloth within it: a sphere that is fixed to the middle of a triangle in the node's middle, and felt there.
struct Contact {
    int triangle = 0;
    int ball = 0;
    std::array<int, 3> corners{};       ///< its particles
    std::array<Real, 3> barycentric{};  ///< of the triangle's point that is closest to the ball's centre
    Vec3 point = Vec3::Zero();          ///< that point [m]
    Vec3 normal = Vec3::Zero();         ///< from the ball to the cloth, length 1
    Real depth = 0;                     ///< radius + thickness - distance > 0 [m]
    Real inverse_mass = 0;              ///< that a push at the point meets; filled by the response [1/kg]
    Real leaving_speed = 0;             ///< along the normal, that the response aims at [m/s]
    Real impulse = 0;                   ///< along the normal, given by the response [N s]
    bool of_node = false;               ///< only then there is a sphere:
    Vec3 offset = Vec3::Zero();         ///< from `point` to its centre [m]
    Real radius = 0;                    ///< that counts towards the depth [m]
};

/// The touched triangles, exactly: those whose distance to the ball's centre is at most radius + thickness.
/// @param x n x 3 [m]
/// @param cells candidate cells
/// @param triangles receives the triangle numbers, in the order of `cells`; cleared first
void find_touched_triangles(const Grid& grid, const Points& x, const Ball& ball, Real thickness,
                            std::span<const CellRun> cells, std::vector<int>& triangles, Kernels kernels);

/// The contacts of the candidate cells' triangles with one ball, appended.
/// @param ball_number is stored with each contact
/// @param kernels plain: each cell is tested; vector: cells that their corners show to be too far are left out first
/// @return how many of the cells touch
std::int64_t find_contacts(const Grid& grid, const Points& x, const Ball& ball, int ball_number, Real thickness,
                           std::span<const CellRun> cells, std::vector<Contact>& contacts, Kernels kernels);

}  // namespace drape
