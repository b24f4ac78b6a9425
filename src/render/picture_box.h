#pragma once

#include <Eigen/Core>
#include <span>

#include "cloth_mesh.h"

namespace drape {

/// A rectangle of a picture, from its lower left corner [pixel].
struct PictureBox {
    int left = 0, low = 0, width = 0, height = 0;
};

/// Around all particles and balls as they are drawn; the whole picture if one of them is beside or behind the eye.
/// @param balls centre and radius [m]
PictureBox solid_box(const Eigen::Matrix4f& view_projection, std::span<const ClothVertex> cloth,
                     std::span<const Eigen::Vector4f> balls, int width, int height);

}  // namespace drape
