#include "frame_data.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace drape {

namespace {

const Eigen::Vector3f to_light = Eigen::Vector3f(-0.42f, 1.0f, 0.5f).normalized();

// Steps of the shadow map's width, so that its texels do not crawl as the cloth moves
constexpr float extent_step = 0.25f;

Eigen::Matrix4f light_matrix(const Extent& extent, int texels) {
    const Eigen::Vector3f side = Eigen::Vector3f::UnitX().cross(to_light).cross(to_light).normalized();
    const Eigen::Vector3f up = to_light.cross(side);
    Eigen::Matrix3f axes;
    axes << side.transpose(), up.transpose(), -to_light.transpose();

    // The map's middle moves by whole texels
    const float texel = 2 * extent.radius / static_cast<float>(texels);
    Eigen::Vector3f middle = axes * extent.centre;
    middle.head<2>() = (middle.head<2>() / texel).array().round().matrix() * texel;

    Eigen::Matrix4f matrix = Eigen::Matrix4f::Identity();
    matrix.topLeftCorner<3, 3>() = axes / extent.radius;
    matrix.topRightCorner<3, 1>() = -middle / extent.radius;
    return matrix;
}

}  // namespace

Eigen::Vector4f drawn_ball(const FrameView& view, std::size_t number) {
    const Ball& now = view.balls[number];
    Vec3 centre = now.centre;
    if (number < view.previous_balls.size()) {
        const Vec3& before = view.previous_balls[number].centre;
        centre = before + view.blend * (now.centre - before);
    }
    Eigen::Vector4f ball;
    ball << centre.cast<float>(), static_cast<float>(now.radius);
    return ball;
}

Extent drawn_extent(const FrameView& view) {
    Eigen::AlignedBox<Real, 3> box;
    for (const Cloth& cloth : view.cloths) {
        if (cloth.state.x.rows() == 0) continue;
        box.extend(Vec3(cloth.state.x.colwise().minCoeff()));
        box.extend(Vec3(cloth.state.x.colwise().maxCoeff()));
    }
    for (const Ball& ball : view.balls) {
        box.extend(Vec3(ball.centre.array() - ball.radius));
        box.extend(Vec3(ball.centre.array() + ball.radius));
    }
    Extent extent;
    if (!box.isEmpty() && box.sizes().allFinite()) {
        extent.centre = box.center().cast<float>();
        extent.radius = std::max(0.01f, 0.5f * static_cast<float>(box.diagonal().norm()));
    }
    return extent;
}

FrameData make_frame_data(const FrameView& view, const Camera& camera, int width, int height, int shadow_texels) {
    FrameData data{};
    const float aspect = static_cast<float>(width) / static_cast<float>(height);
    data.view_projection = camera.projection_matrix(aspect) * camera.view_matrix();
    data.inverse_view_projection = data.view_projection.inverse();
    const Eigen::Vector3f eye = camera.eye();
    data.eye = {eye.x(), eye.y(), eye.z(), 1};
    data.to_light = {to_light.x(), to_light.y(), to_light.z(), 0};
    data.viewport << static_cast<float>(width), static_cast<float>(height), 1 / static_cast<float>(width),
        1 / static_cast<float>(height);

    Extent lit = drawn_extent(view);
    lit.radius = extent_step * std::ceil(1.02f * lit.radius / extent_step);
    data.shadow_matrix = light_matrix(lit, shadow_texels);
    data.shadow << 2 * lit.radius / static_cast<float>(shadow_texels), 1 / static_cast<float>(shadow_texels), 1, 0;

    // The stage lies about what the scene looks at
    const ViewSettings& settings = view.settings->view;
    const Vec3 target = settings.target;
    const auto distance = static_cast<float>((settings.eye - settings.target).norm());
    data.stage << static_cast<float>(target.x()), static_cast<float>(settings.ground), static_cast<float>(target.z()),
        std::max(0.5f, distance);

    const std::size_t balls = std::min<std::size_t>(view.balls.size(), FrameData::most_balls);
    for (std::size_t i = 0; i < balls; ++i) data.balls[i] = drawn_ball(view, i);
    data.counts = {0, 0, 0, static_cast<int>(balls)};
    return data;
}

}  // namespace drape
