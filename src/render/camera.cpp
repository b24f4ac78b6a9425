#include "drape/render/camera.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "frame_data.h"

namespace drape {

namespace {

constexpr float field_of_view = 38 * std::numbers::pi_v<float> / 180;  // of the picture's height
constexpr float steepest = 1.5f;  // pitch [rad]: short of the poles, where the yaw would lose its meaning
constexpr float least_distance = 0.1f, most_distance = 60;  // to the target [m]
constexpr float eye_height = 0.04f;                         // above the ground, at least, as a part of the distance

float number(double value) { return std::isfinite(value) ? static_cast<float>(value) : 0.0f; }

// Backwards, to the right and up, as a camera sees it
struct Axes {
    Eigen::Vector3f back, right, up;
};

Axes axes_of(float yaw, float pitch) {
    Axes axes;
    axes.back = {std::sin(yaw) * std::cos(pitch), std::sin(pitch), std::cos(yaw) * std::cos(pitch)};
    axes.right = {std::cos(yaw), 0, -std::sin(yaw)};
    axes.up = axes.back.cross(axes.right);
    return axes;
}

// Around all cloths, balls and solids; empty if there are none, or not at numbers
Eigen::AlignedBox3f box_of(const FrameView& view) {
    Eigen::AlignedBox<Real, 3> box;
    for (const ClothView& cloth : view.cloths) {
        box.extend(Vec3(cloth.x.colwise().minCoeff()));
        box.extend(Vec3(cloth.x.colwise().maxCoeff()));
    }
    for (const Ball& ball : view.balls) {
        box.extend(Vec3(ball.centre.array() - ball.radius));
        box.extend(Vec3(ball.centre.array() + ball.radius));
    }
    for (std::size_t i = 0; i < view.solids.size(); ++i) {
        box.extend(drawn_solid_box(view, i, Eigen::Matrix3f::Identity()).cast<Real>());
    }
    const Eigen::AlignedBox3f rounded = box.cast<float>();
    return rounded.sizes().allFinite() ? rounded : Eigen::AlignedBox3f();
}

constexpr Real nothing = std::numeric_limits<Real>::infinity();

struct Hit {
    Real distance = nothing;
    std::array<Real, 3> barycentric{};
};

// A ray against both sides of a triangle  @cite moller1997
Hit hit_triangle(const Ray& ray, const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 ab = b - a, ac = c - a, p = ray.direction.cross(ac);
    const Real determinant = ab.dot(p);
    if (std::abs(determinant) < std::numeric_limits<Real>::min()) return {};
    const Vec3 s = ray.origin - a, q = s.cross(ab);
    const Real v = s.dot(p) / determinant, w = ray.direction.dot(q) / determinant, t = ac.dot(q) / determinant;
    if (!(v >= 0 && w >= 0 && v + w <= 1 && t > 0)) return {};
    return {t, {1 - v - w, v, w}};
}

Real hit_ball(const Ray& ray, const Vec3& centre, Real radius) {
    const Vec3 to_centre = centre - ray.origin;
    const Real middle = to_centre.dot(ray.direction);
    const Real inside = radius * radius - (to_centre - middle * ray.direction).squaredNorm();
    if (inside < 0 || middle - std::sqrt(inside) <= 0) return nothing;
    return middle - std::sqrt(inside);
}

// By steps of the distance, which meet nothing on their way
Real hit_solid(const Ray& ray, const Solid& solid) {
    constexpr Real near = Real(1e-4), far = 1000;
    constexpr int most_steps = 256;
    Real along = 0;
    for (int step = 0; step < most_steps && along < far; ++step) {
        const Real distance = solid.distance(ray.origin + along * ray.direction);
        if (distance < near) return along;
        along += distance;
    }
    return nothing;
}

}  // namespace

Camera::Camera(const ViewSettings& view) : target_(view.target.cast<float>()), yaw_(0), pitch_(0), distance_(1) {
    const Eigen::Vector3f offset = (view.eye - view.target).cast<float>();
    const float length = offset.norm();
    if (!(length > 1e-6f)) return;
    distance_ = std::clamp(length, least_distance, most_distance);
    yaw_ = std::atan2(offset.x(), offset.z());
    pitch_ = std::clamp(std::asin(std::clamp(offset.y() / length, -1.0f, 1.0f)), -steepest, steepest);
}

void Camera::apply(const Command& command, const FrameView& view) {
    if (const auto* orbit = std::get_if<command::Orbit>(&command)) {
        yaw_ = std::remainder(yaw_ + number(orbit->yaw), 2 * std::numbers::pi_v<float>);
        pitch_ = std::clamp(pitch_ + number(orbit->pitch), -steepest, steepest);
    } else if (const auto* pan = std::get_if<command::Pan>(&command)) {
        const Axes axes = axes_of(yaw_, pitch_);
        // A cube around the scene, and no jump into it
        const Eigen::AlignedBox3f scene = box_of(view);
        const Eigen::Vector3f reach = Eigen::Vector3f::Constant(scene.diagonal().norm() / 2);
        const auto allowed = Eigen::AlignedBox3f(scene.center() - reach, scene.center() + reach).extend(target_);
        target_ += distance_ * (number(pan->right) * axes.right + number(pan->up) * axes.up);
        target_ = target_.cwiseMax(allowed.min()).cwiseMin(allowed.max());
    } else if (const auto* zoom = std::get_if<command::Zoom>(&command)) {
        if (zoom->factor > 0) distance_ = std::clamp(distance_ * number(zoom->factor), least_distance, most_distance);
    } else if (std::holds_alternative<command::Frame>(command)) {
        const Eigen::AlignedBox3f box = box_of(view);
        if (box.isEmpty()) return;
        target_ = box.center();
        distance_ =
            std::clamp(box.diagonal().norm() / (2 * std::sin(field_of_view / 2)), least_distance, most_distance);
    } else if (std::holds_alternative<command::Home>(command)) {
        *this = Camera(view.settings->view);
    } else {
        return;
    }
    // Above the ground, under which there is nothing to see
    if (!view.settings->ground.solid) return;
    const auto height = static_cast<float>(view.settings->ground.height);
    target_.y() = std::max(target_.y(), height);
    const float lowest = eye_height + (height - target_.y()) / distance_;
    pitch_ = std::min(std::max(pitch_, std::asin(std::clamp(lowest, -1.0f, 1.0f))), steepest);
}

bool Camera::ease_towards(const Camera& goal, double elapsed) {
    constexpr double pace = 0.1;       // s
    constexpr float unseen = 2.5e-4f;  // of the distance, and of a radian: a quarter of a pixel
    if (*this == goal) return false;
    const auto part = static_cast<float>(-std::expm1(-std::max(elapsed, 0.0) / pace));
    const float turn = std::remainder(goal.yaw_ - yaw_, 2 * std::numbers::pi_v<float>);
    yaw_ = std::remainder(yaw_ + part * turn, 2 * std::numbers::pi_v<float>);
    pitch_ += part * (goal.pitch_ - pitch_);
    target_ += part * (goal.target_ - target_);
    distance_ *= std::pow(goal.distance_ / distance_, part);

    const float left = std::abs(1 - part) * std::abs(turn) + std::abs(goal.pitch_ - pitch_) +
                       (goal.target_ - target_).norm() / distance_ + std::abs(goal.distance_ / distance_ - 1);
    if (!(left > unseen)) *this = goal;
    return true;
}

Eigen::Vector3f Camera::eye() const { return target_ + distance_ * axes_of(yaw_, pitch_).back; }

Eigen::Matrix4f Camera::view_matrix() const {
    const Axes axes = axes_of(yaw_, pitch_);
    Eigen::Matrix4f matrix = Eigen::Matrix4f::Identity();
    matrix.topLeftCorner<3, 3>() << axes.right.transpose(), axes.up.transpose(), axes.back.transpose();
    matrix.topRightCorner<3, 1>() = -matrix.topLeftCorner<3, 3>() * eye();
    return matrix;
}

Eigen::Matrix4f Camera::projection_matrix(float aspect) const {
    // The planes move with the distance, so that depth stays fine close by
    const float near = std::clamp(0.05f * distance_, 0.01f, 0.5f), far = 40 * distance_ + 40;
    const float scale = 1 / std::tan(field_of_view / 2);
    Eigen::Matrix4f matrix = Eigen::Matrix4f::Zero();
    matrix(0, 0) = scale / aspect;
    matrix(1, 1) = scale;
    matrix(2, 2) = (near + far) / (near - far);
    matrix(2, 3) = 2 * near * far / (near - far);
    matrix(3, 2) = -1;
    return matrix;
}

Ray Camera::ray(int x, int y, int width, int height) const {
    const Axes axes = axes_of(yaw_, pitch_);
    const float half = std::tan(field_of_view / 2);
    const auto w = static_cast<float>(std::max(width, 1)), h = static_cast<float>(std::max(height, 1));
    const float right = ((static_cast<float>(x) + 0.5f) / w * 2 - 1) * half * w / h;
    const float up = (1 - (static_cast<float>(y) + 0.5f) / h * 2) * half;
    const Eigen::Vector3f direction = right * axes.right + up * axes.up - axes.back;
    return {eye().cast<Real>(), direction.normalized().cast<Real>()};
}

bool Camera::sees(const Ball& ball, float aspect) const {
    const Eigen::Matrix4f projection = projection_matrix(aspect);
    const Eigen::Vector4f centre = view_matrix() * ball.centre.cast<float>().homogeneous();
    const auto radius = static_cast<float>(ball.radius);
    // By its distance from the planes through the eye and the picture's edges
    const auto is_within = [&](int axis) {
        const float slope = projection(axis, axis);
        return slope * std::abs(centre[axis]) + centre.z() < radius * std::hypot(slope, 1.0f);
    };
    return is_within(0) && is_within(1);
}

command::Throw Camera::aimed_throw() const {
    constexpr float before = 0.5F, speed = 6, lift = 1.2F;  // m, m/s, and m/s up against what it falls on its way
    const Eigen::Vector3f sight = (target_ - eye()).normalized();
    const Eigen::Vector3f velocity = speed * sight + lift * Eigen::Vector3f::UnitY();
    return {(eye() + before * sight).cast<Real>(), velocity.cast<Real>()};
}

Vec3 Camera::on_facing_plane(const Ray& ray, const Vec3& through) const {
    const Vec3 normal = axes_of(yaw_, pitch_).back.cast<Real>();
    const Real towards = ray.direction.dot(normal);
    if (std::abs(towards) < Real(1e-6)) return through;
    return ray.origin + ray.direction * ((through - ray.origin).dot(normal) / towards);
}

Vec3 Camera::right() const { return axes_of(yaw_, 0).right.cast<Real>(); }

Vec3 Camera::ahead() const { return -axes_of(yaw_, 0).back.cast<Real>(); }

Pick pick_particle(const FrameView& view, const Ray& ray) {
    Pick pick;
    Real nearest = nothing;
    for (std::size_t i = 0; i < view.balls.size(); ++i) {
        const Eigen::Vector4f ball = drawn_ball(view, i);
        const Vec3 centre = ball.head<3>().cast<Real>();
        const Real distance = hit_ball(ray, centre, static_cast<Real>(ball.w()));
        if (!(distance < nearest)) continue;
        nearest = distance;
        pick.ball = static_cast<int>(i);
        pick.point = ray.origin + distance * ray.direction;
        pick.to_centre = centre - pick.point;
    }
    for (std::size_t i = 0; i < view.solids.size(); ++i) {
        Solid solid = view.solids[i];
        solid.position = drawn_solid(view, i).cast<Real>();
        const Real distance = hit_solid(ray, solid);
        if (distance < nearest) nearest = distance, pick = {};
    }
    for (std::size_t number = 0; number < view.cloths.size(); ++number) {
        const ClothView& cloth = view.cloths[number];
        const Grid& grid = cloth.model.grid;
        for (int triangle = 0; triangle < grid.triangles(); ++triangle) {
            const std::array<int, 3> corners = grid.triangle_corners(triangle);
            const Hit hit = hit_triangle(ray, drawn_particle(cloth, view.blend, corners[0]),
                                         drawn_particle(cloth, view.blend, corners[1]),
                                         drawn_particle(cloth, view.blend, corners[2]));
            if (!(hit.distance < nearest)) continue;
            nearest = hit.distance;
            const auto largest = std::max_element(hit.barycentric.begin(), hit.barycentric.end());
            pick = {.cloth = static_cast<int>(number),
                    .particle = corners[static_cast<std::size_t>(largest - hit.barycentric.begin())],
                    .point = ray.origin + hit.distance * ray.direction};
        }
    }
    return pick;
}

}  // namespace drape
