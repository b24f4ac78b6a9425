#pragma once

#include "drape/render/camera.h"

namespace drape::test {

/// A cloth at rest, which a test may move, and a view of it.
struct RestingCloth {
    explicit RestingCloth(const Grid& grid, ClothParameters parameters = {}) {
        parameters.particles = grid;
        model = make_cloth_model(parameters);
        x = previous = make_rest_state(parameters).x;
    }
    RestingCloth(const RestingCloth&) = delete;

    ClothModel model;
    Points x, previous;
    ClothView view{model, x, previous, {}, nullptr};
};

/// The pixel in which a camera sees a point.
inline Eigen::Vector2i pixel_of(const Vec3& point, const Camera& camera, int width, int height) {
    const Eigen::Vector2f size(static_cast<float>(width), static_cast<float>(height));
    const Eigen::Matrix4f matrix = camera.projection_matrix(size.x() / size.y()) * camera.view_matrix();
    const Eigen::Vector3f seen = (matrix * point.cast<float>().homogeneous()).hnormalized();
    return (Eigen::Array2f(1 + seen.x(), 1 - seen.y()) / 2 * size.array()).cast<int>();
}

}  // namespace drape::test
