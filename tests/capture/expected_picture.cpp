#include "expected_picture.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace drape::test {

namespace {

constexpr double half_view = 19 * std::numbers::pi / 180;  // half of the angle that the picture's height takes
const Vec3 to_light = Vec3(-0.42, 1.0, 0.5).normalized();
constexpr double soft = 0.06;  // half the width of a shadow's edge that is left out [m]

bool hits_triangle(const Vec3& from, const Vec3& way, const Vec3& a, const Vec3& b, const Vec3& c) {
    Eigen::Matrix3d edges;
    edges << (b - a), (c - a), -way;
    const double volume = edges.determinant();
    if (std::abs(volume) < 1e-14) return false;
    const Vec3 part = edges.inverse() * (from - a);
    return part[0] >= 0 && part[1] >= 0 && part[0] + part[1] <= 1 && part[2] > 0;
}

bool light_reaches(const FrameView& view, const Vec3& point) {
    for (const Ball& ball : view.balls) {
        const Vec3 to_ball = ball.centre - point;
        if ((to_ball - to_ball.dot(to_light) * to_light).norm() < ball.radius) return false;
    }
    for (const ClothView& cloth : view.cloths) {
        const Grid& grid = cloth.model.grid;
        for (int t = 0; t < grid.triangles(); ++t) {
            const auto [a, b, c] = grid.triangle_corners(t);
            const Points& x = cloth.x;
            if (hits_triangle(point, to_light, x.row(a), x.row(b), x.row(c))) return false;
        }
    }
    return true;
}

}  // namespace

ExpectedPicture::ExpectedPicture(const FrameView& view, int width, int height)
    : width_(width),
      height_(height),
      eye_(view.settings->view.eye),
      pixels_per_slope_(height / (2 * std::tan(half_view))),
      seen_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), Seen::Nothing),
      depth_(seen_.size(), std::numeric_limits<double>::infinity()) {
    ahead_ = (view.settings->view.target - eye_).normalized();
    right_ = ahead_.cross(Vec3(0, 1, 0)).normalized();
    up_ = right_.cross(ahead_);
    for (const ClothView& cloth : view.cloths) fill_cloth(cloth);
    for (const Ball& ball : view.balls) fill_ball(ball);
    for (const ClothView& cloth : view.cloths) {
        for (int p = 0; p < cloth.model.grid.particles(); ++p) {
            if (cloth.model.pinned(p)) fill_cord(cloth.x.row(p));
        }
    }
}

ExpectedPicture::Projected ExpectedPicture::project(const Vec3& point) const {
    const Vec3 offset = point - eye_;
    const double depth = offset.dot(ahead_);
    return {width_ / 2.0 + pixels_per_slope_ * offset.dot(right_) / depth,
            height_ / 2.0 - pixels_per_slope_ * offset.dot(up_) / depth, depth};
}

Vec3 ExpectedPicture::direction(double x, double y) const {
    return (ahead_ + right_ * (x - width_ / 2.0) / pixels_per_slope_ - up_ * (y - height_ / 2.0) / pixels_per_slope_)
        .normalized();
}

void ExpectedPicture::fill_cloth(const ClothView& cloth) {
    for (int t = 0; t < cloth.model.grid.triangles(); ++t) {
        const auto corners = cloth.model.grid.triangle_corners(t);
        std::array<Projected, 3> p;
        for (std::size_t i = 0; i < 3; ++i) p[i] = project(cloth.x.row(corners[i]));
        const auto side = [](const Projected& a, const Projected& b, double x, double y) {
            return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
        };
        const double area = side(p[0], p[1], p[2].x, p[2].y);
        if (area == 0) continue;
        // The picture's y points down, so that a front turns the other way round
        const Seen seen = area < 0 ? Seen::Front : Seen::Back;
        const auto [left, right] = std::minmax({p[0].x, p[1].x, p[2].x});
        const auto [top, bottom] = std::minmax({p[0].y, p[1].y, p[2].y});
        for (int y = std::max(0, static_cast<int>(top)); y <= std::min(height_ - 1, static_cast<int>(bottom)); ++y) {
            for (int x = std::max(0, static_cast<int>(left)); x <= std::min(width_ - 1, static_cast<int>(right)); ++x) {
                const double a = side(p[1], p[2], x + 0.5, y + 0.5) / area,
                             b = side(p[2], p[0], x + 0.5, y + 0.5) / area;
                if (a < 0 || b < 0 || a + b > 1) continue;
                const double depth = 1 / (a / p[0].depth + b / p[1].depth + (1 - a - b) / p[2].depth);
                if (depth >= depth_[index(x, y)]) continue;
                depth_[index(x, y)] = depth;
                seen_[index(x, y)] = seen;
            }
        }
    }
}

void ExpectedPicture::fill_ball(const Ball& ball) {
    const Vec3 to_ball = ball.centre - eye_;
    for (int y = 0; y < height_; ++y) {
        for (int x = 0; x < width_; ++x) {
            const Vec3 way = direction(x + 0.5, y + 0.5);
            const double middle = to_ball.dot(way);
            const double inside = ball.radius * ball.radius - (to_ball - middle * way).squaredNorm();
            if (inside < 0) continue;
            const double depth = (middle - std::sqrt(inside)) * way.dot(ahead_);
            if (depth >= depth_[index(x, y)]) continue;
            depth_[index(x, y)] = depth;
            seen_[index(x, y)] = Seen::Ball;
        }
    }
}

// Pins hang from something above them
void ExpectedPicture::fill_cord(const Vec3& pin) {
    constexpr int beside = 2;  // pixel
    const Projected from = project(pin), above = project(pin + Vec3(0, 1, 0));
    for (int y = std::min(static_cast<int>(from.y), height_ - 1); y >= 0; --y) {
        const double x = from.x + (from.y - y) / (from.y - above.y) * (above.x - from.x);
        for (int i = static_cast<int>(x) - beside; i <= static_cast<int>(x) + beside; ++i) {
            if (i >= 0 && i < width_) seen_[index(i, y)] = Seen::Cord;
        }
    }
}

bool ExpectedPicture::surely(Seen what, int x, int y, int margin) const {
    for (int j = y - margin; j <= y + margin; ++j) {
        for (int i = x - margin; i <= x + margin; ++i) {
            if (i < 0 || j < 0 || i >= width_ || j >= height_ || at(i, j) != what) return false;
        }
    }
    return true;
}

int ExpectedPicture::count(Seen what) const { return static_cast<int>(std::count(seen_.begin(), seen_.end(), what)); }

std::vector<ExpectedPicture::OutlinePoint> ExpectedPicture::ball_outline(const FrameView& view,
                                                                         std::size_t number) const {
    // The circle in which the cone of sight touches the ball
    const Ball& ball = view.balls[number];
    const Vec3 to_eye = eye_ - ball.centre;
    const double far = to_eye.norm(), sine = ball.radius / far;
    const Vec3 middle = ball.centre + to_eye * (sine * sine);
    const double radius = ball.radius * std::sqrt(1 - sine * sine);
    const Vec3 across = to_eye.cross(up_).normalized(), along = across.cross(to_eye).normalized();
    const Projected centre = project(middle);

    std::vector<OutlinePoint> points;
    for (int i = 0; i < 360; ++i) {
        const double turn = i * std::numbers::pi / 180;
        const Projected p = project(middle + radius * (std::cos(turn) * across + std::sin(turn) * along));
        const double length = std::hypot(p.x - centre.x, p.y - centre.y);
        const OutlinePoint point{p.x, p.y, (p.x - centre.x) / length, (p.y - centre.y) / length};
        const auto seen = [&](double away) {
            const int x = static_cast<int>(p.x + away * point.out_x), y = static_cast<int>(p.y + away * point.out_y);
            return x < 0 || y < 0 || x >= width_ || y >= height_ ? Seen::Front : at(x, y);
        };
        bool clear = true;
        for (const double away : {3.0, 6.0, 9.0, 12.0})
            clear = clear && seen(-away) == Seen::Ball && seen(away) == Seen::Nothing;
        if (clear) points.push_back(point);
    }
    return points;
}

ExpectedPicture::Ground ExpectedPicture::ground_at(const FrameView& view, int x, int y) const {
    if (!surely(Seen::Nothing, x, y, 3)) return Ground::Unclear;
    const Vec3 way = direction(x + 0.5, y + 0.5);
    if (way.y() > -0.05) return Ground::Unclear;
    const Vec3 point = eye_ + way * ((view.settings->ground.height - eye_.y()) / way.y());
    if ((point - view.settings->view.target).norm() > 1.2) return Ground::Unclear;
    int reached = 0;
    for (const auto& [dx, dz] :
         std::array<std::array<double, 2>, 5>{{{0, 0}, {soft, 0}, {-soft, 0}, {0, soft}, {0, -soft}}}) {
        reached += light_reaches(view, point + Vec3(dx, 0, dz)) ? 1 : 0;
    }
    return reached == 5 ? Ground::Lit : reached == 0 ? Ground::Shadowed : Ground::Unclear;
}

}  // namespace drape::test
