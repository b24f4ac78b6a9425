#include "drape/contact/impact.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "bernstein.h"
#include "drape/contact/closest_point.h"

namespace drape {
namespace {

constexpr Real impact_epsilon = std::numeric_limits<Real>::epsilon();
/// Of the terms that a polynomial's coefficients are made of: what their rounding may come to.
constexpr double coefficient_rounding = 64 * std::numeric_limits<double>::epsilon();

using Corners3 = std::array<Vec3, 3>;

/// A triangle as the ball's centre sees it, over the whole step.
struct SeenTriangle {
    Corners3 start, end;
    Real radius = 0;
    Real rounding = 0;  ///< of a distance [m]

    /// Of the corners, and so of all of it [m a step].
    [[nodiscard]] Real fastest() const {
        Real square = 0;
        for (std::size_t k = 0; k < 3; ++k) square = std::max(square, (end[k] - start[k]).squaredNorm());
        return std::sqrt(square);
    }

    [[nodiscard]] Corners3 at(Real t) const {
        Corners3 corners;
        for (std::size_t k = 0; k < 3; ++k) corners[k] = (1 - t) * start[k] + t * end[k];
        return corners;
    }
};

/// Part of the step.
struct Stretch {
    Real begin = 0, end = 1;
};

SeenTriangle seen_from(const SweptBall& ball, const Corners3& from, const Corners3& to) {
    SeenTriangle seen;
    seen.radius = ball.radius;
    Real size = ball.radius;
    for (std::size_t k = 0; k < 3; ++k) {
        seen.start[k] = from[k] - ball.start;
        seen.end[k] = to[k] - ball.end;
        size = std::max({size, seen.start[k].cwiseAbs().maxCoeff(), seen.end[k].cwiseAbs().maxCoeff()});
    }
    seen.rounding = 16 * impact_epsilon * size;
    return seen;
}

/// Shortens a stretch by the times at which all corners are beyond the ball on one side of it: those after some time,
/// before one, or between two, of which none is left out.
/// @param ahead how far each corner is beyond that side, at the step's beginning and end
void clip_stretch(const std::array<Real, 3>& ahead_first, const std::array<Real, 3>& ahead_last, Stretch& stretch) {
    Real from = 0, until = 1;
    for (std::size_t k = 0; k < 3; ++k) {
        const Real first = ahead_first[k], last = ahead_last[k];
        if (!(first > 0 || last > 0)) return;
        if (first > 0 && last > 0) continue;
        const Real passing = first / (first - last);
        if (first > 0)
            until = std::min(until, passing);
        else
            from = std::max(from, passing);
    }
    if (!(from < until)) return;
    if (from <= stretch.begin) stretch.begin = std::max(stretch.begin, until);
    if (until >= stretch.end) stretch.end = std::min(stretch.end, from);
}

/// From when to when the boxes about ball and triangle may meet; none if they never do.
std::optional<Stretch> meeting_of_boxes(const SeenTriangle& seen) {
    const Real reach = seen.radius + seen.rounding;
    Stretch stretch;
    for (int axis = 0; axis < 3; ++axis) {
        for (const Real side : {Real(1), Real(-1)}) {
            std::array<Real, 3> first, last;
            for (std::size_t k = 0; k < 3; ++k) {
                first[k] = side * seen.start[k][axis] - reach;
                last[k] = side * seen.end[k][axis] - reach;
            }
            if (std::ranges::min(first) > 0 && std::ranges::min(last) > 0) return std::nullopt;
            clip_stretch(first, last, stretch);
        }
    }
    if (stretch.begin > stretch.end) return std::nullopt;
    return stretch;
}

/// How near ball and triangle are at some time.
struct Nearness {
    Real time;
    ClosestPoint closest;   ///< from the ball's centre
    Real distance, beyond;  ///< of its centre and of its surface [m]
    Vec3 velocity;          ///< of the closest point [m a step]

    /// How fast the distance shrinks [m a step].
    [[nodiscard]] Real closing() const { return distance > 0 ? -closest.point.dot(velocity) / distance : Real(0); }
};

Nearness nearness_at(const SeenTriangle& seen, Real t) {
    const auto [a, b, c] = seen.at(t);
    Nearness near;
    near.time = t;
    near.closest = closest_point_on_triangle(Vec3::Zero(), a, b, c);
    near.distance = near.closest.point.norm();
    near.beyond = near.distance - seen.radius;
    near.velocity = Vec3::Zero();
    for (std::size_t i = 0; i < 3; ++i) near.velocity += near.closest.barycentric[i] * (seen.end[i] - seen.start[i]);
    return near;
}

/// Follows the distance from a time at which ball and triangle do not touch until they do: by Newton's method, and
/// where that has gone too far in, within bounds that are halved now and then.
/// @param longest that this may take, in parts of the step
/// @return the last time tried, or the first if that is the nearer
Nearness follow_to_touch(const SeenTriangle& seen, const Nearness& first, Real longest) {
    constexpr int patience = 120;
    Nearness now = first;
    Real outside = first.time, inside = 2;
    for (int k = 0; k < patience; ++k) {
        if (now.beyond > seen.rounding / 16)
            outside = now.time;
        else if (now.beyond < -seen.rounding && now.time > outside)
            inside = now.time;
        else
            break;
        const Real closing = now.closing();
        Real next = closing > 0 ? now.time + now.beyond / closing : outside;
        if (inside > 1)
            next = std::min({next, first.time + longest, Real(1)});
        else if (!(next > outside && next < inside) || k % 4 == 3)
            next = (outside + inside) / 2;
        if (!(next > outside && next < inside) || next == now.time) break;
        now = nearness_at(seen, next);
    }
    return now.beyond <= std::max(seen.rounding, first.beyond) ? now : first;
}

/// A triangle through the very centre is met along its own normal.
Impact impact_of(const SeenTriangle& seen, const Nearness& near) {
    if (near.distance > 0) return {near.time, near.closest.barycentric, near.closest.point / near.distance};
    const auto [a, b, c] = seen.at(near.time);
    const Vec3 normal = (b - a).cross(c - a).stableNormalized();
    if (normal.isZero(0)) return {near.time, near.closest.barycentric, Vec3(0, 1, 0)};
    return {near.time, near.closest.barycentric, near.velocity.dot(normal) > 0 ? Vec3(-normal) : normal};
}

/// Whether a touch is certainly the first: where all corners come towards the plane between ball and triangle, from
/// beyond it, the triangle was beyond it before. Each at a part of the speed of the fastest at least, so that rounding
/// does not matter; else it must be looked for.
bool is_first(const SeenTriangle& seen, const Impact& touch) {
    const Real slowest = seen.fastest() / 16;
    const auto at_touch = seen.at(touch.time);
    for (std::size_t k = 0; k < 3; ++k) {
        const bool is_beyond = touch.normal.dot(at_touch[k]) > seen.radius - 4 * seen.rounding;
        if (!is_beyond || !(-touch.normal.dot(seen.end[k] - seen.start[k]) > slowest)) return false;
    }
    return true;
}

/// Whether the triangle surely stays beyond a plane beside the ball, along the way of the point that came near.
bool passes_beside(const SeenTriangle& seen, const Nearness& near) {
    const Real square = near.velocity.squaredNorm();
    if (!(square > 0)) return false;
    const Vec3& offset = near.closest.point;
    const Vec3 aside = (offset - offset.dot(near.velocity) / square * near.velocity).stableNormalized();
    const Real reach = seen.radius + 2 * seen.rounding;
    for (std::size_t k = 0; k < 3; ++k) {
        if (!(aside.dot(seen.start[k]) > reach && aside.dot(seen.end[k]) > reach)) return false;
    }
    return true;
}

/// The search for the first touch within a stretch in which there may be one.
class ImpactSearch {
public:
    ImpactSearch(const SeenTriangle& seen, const Stretch& stretch) : seen_(seen), stretch_(stretch) {}

    std::optional<Impact> first() {
        if (!narrow()) return best_;
        look_closer();
        if (!search_face()) return best_;
        for (std::size_t k = 0; k < 3; ++k) search_edge(corners_[k], corners_[(k + 1) % 3]);
        for (std::size_t k = 0; k < 3; ++k) search_corner(corners_[k]);
        return best_;
    }

private:
    using Fine3 = Eigen::Vector3d;
    using Linear = std::array<Fine3, 2>;  ///< of u, from 0 at the stretch's beginning to 1 at its end

    template <std::size_t M, std::size_t N>
    static auto dot(const std::array<Fine3, M>& f, const std::array<Fine3, N>& g) {
        return bernstein::product(
            f, g, [](const Fine3& a, const Fine3& b) { return a.dot(b); }, 0.0);
    }
    static auto cross(const Linear& f, const Linear& g) {
        return bernstein::product(
            f, g, [](const Fine3& a, const Fine3& b) -> Fine3 { return a.cross(b); }, Fine3(Fine3::Zero()));
    }
    template <std::size_t M, std::size_t N>
    static auto times(const std::array<double, M>& f, const std::array<double, N>& g) {
        return bernstein::product(
            f, g, [](double a, double b) { return a * b; }, 0.0);
    }

    /// Shortens the stretch to where the first touch may be: not where the triangle cannot get to the ball at its
    /// speed, and not after a touch that is found by following the distance.
    /// @return false if none is left
    bool narrow() {
        const Nearness first = nearness_at(seen_, stretch_.begin);
        const Real fastest = seen_.fastest(), length = stretch_.end - stretch_.begin;
        if (first.beyond > fastest * length + seen_.rounding) return false;
        const Nearness near = follow_to_touch(seen_, first, length);
        if (near.beyond > seen_.rounding) return !passes_beside(seen_, near);
        best_ = impact_of(seen_, near);
        if (is_first(seen_, *best_)) return false;
        // Far enough before the touch for its own root to be beyond, unless it grazes
        const bool head_on = near.closing() > fastest / 16;
        stretch_.end = near.time - (head_on ? 64 * seen_.rounding / near.closing() : Real(0));
        return stretch_.begin < stretch_.end;
    }

    /// Corners within the stretch alone, in units of the largest distance: neither the step's length nor the scale then
    /// cost digits. The radius is grown, so that a touch that is hidden by the rounding of positions has its root.
    void look_closer() {
        double size = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const Fine3 start = seen_.start[k].cast<double>(), end = seen_.end[k].cast<double>();
            corners_[k] = {(1 - stretch_.begin) * start + stretch_.begin * end,
                           (1 - stretch_.end) * start + stretch_.end * end};
            size = std::max({size, corners_[k][0].norm(), corners_[k][1].norm()});
        }
        for (Linear& corner : corners_) corner[0] /= size, corner[1] /= size;
        const double radius = (seen_.radius + seen_.rounding / 2) / size;
        square_ = radius * radius;
    }

    enum class Trial { Far, Near, Touch };

    /// Whether they touch at about a time, at which a root was found: it may be early by rounding.
    Trial try_at(Real t) {
        const Real root_of_rounding = std::sqrt(impact_epsilon);
        const Nearness first = nearness_at(seen_, t);
        if (first.beyond > 16 * seen_.rounding / root_of_rounding) return Trial::Far;
        const Real longest = 64 * root_of_rounding * (stretch_.end - stretch_.begin);
        const Nearness near = follow_to_touch(seen_, first, longest);
        if (near.beyond > seen_.rounding) return Trial::Near;
        if (!best_ || near.time < best_->time) best_ = impact_of(seen_, near);
        return Trial::Touch;
    }

    [[nodiscard]] Real time_at(double u) const {
        return std::min(stretch_.begin + (stretch_.end - stretch_.begin) * static_cast<Real>(u), stretch_.end);
    }

    /// Tries where a polynomial falls to zero, but for its rounding, until one is a touch or later than the best; where
    /// that was too early to tell, where it falls to zero itself.
    /// @return whether the first such time is one of a touch
    template <std::size_t Size>
    bool try_falls(const std::array<double, Size>& f, double rounding) {
        int falls = 0, undecided = 0;
        const auto visit = [&](double u) {
            const Real t = time_at(u);
            ++falls;
            if (best_ && t >= best_->time) return true;
            const Trial trial = try_at(t);
            undecided += trial == Trial::Near;
            return trial == Trial::Touch;
        };
        std::array<double, Size> lowered = f;
        for (double& coefficient : lowered) coefficient -= rounding;
        const bool touched = bernstein::visit_falls(lowered, visit) && falls == 1;
        if (undecided > 0) bernstein::visit_falls(f, visit);
        return touched;
    }

    /// The plane at n . a = r |n| with the normal n = (b - a) x (c - a): (n . a)^2 - r^2 |n|^2 = 0, of degree 6.
    /// @return false if the whole triangle's first touch is known with this, or that there is none
    bool search_face() {
        const auto& [a, b, c] = corners_;
        const Linear ab{b[0] - a[0], b[1] - a[1]}, ac{c[0] - a[0], c[1] - a[1]};
        const auto n = cross(ab, ac);
        const auto above = dot(n, a);
        const auto area = times(dot(n, n), constant_);
        auto f = times(above, above);
        for (std::size_t i = 0; i < f.size(); ++i) f[i] -= square_ * area[i];
        const double sides =
            std::max(ab[0].squaredNorm(), ab[1].squaredNorm()) * std::max(ac[0].squaredNorm(), ac[1].squaredNorm());
        const double rounding = coefficient_rounding * sides * (1 + square_);
        if (std::ranges::min(f) > rounding) return false;
        // Where the centre's foot on the plane is beyond one edge throughout, that edge is nearer
        const auto is_beyond = [&](const Linear& p, const Linear& q) {
            return std::ranges::max(dot(n, cross(p, q))) < 0;
        };
        if (is_beyond(a, b) || is_beyond(b, c) || is_beyond(c, a)) return true;
        // Before the plane comes as near, the triangle cannot
        return !(try_falls(f, rounding) && f[0] > rounding && std::ranges::min(best_->barycentric) > 0);
    }

    /// The line through a with direction e: |a x e|^2 - r^2 |e|^2 = 0, of degree 4.
    void search_edge(const Linear& a, const Linear& b) {
        const Linear e{b[0] - a[0], b[1] - a[1]};
        // Where the centre's foot on the line is beyond one end throughout, that corner is nearer
        const auto before = dot(a, e), beyond = dot(b, e);
        if (std::ranges::min(before) > 0 || std::ranges::max(beyond) < 0) return;
        const auto moment = cross(a, e);
        const auto length = times(dot(e, e), constant_);
        auto f = dot(moment, moment);
        for (std::size_t i = 0; i < f.size(); ++i) f[i] -= square_ * length[i];
        const double side = std::max(e[0].squaredNorm(), e[1].squaredNorm());
        try_falls(f, coefficient_rounding * side * (1 + square_));
    }

    /// |a|^2 - r^2 = 0, of degree 2.
    void search_corner(const Linear& a) {
        auto f = dot(a, a);
        for (double& coefficient : f) coefficient -= square_;
        try_falls(f, coefficient_rounding * (1 + square_));
    }

    static constexpr std::array<double, 3> constant_{1, 1, 1};  ///< raises the degree by two

    const SeenTriangle& seen_;
    Stretch stretch_;
    std::array<Linear, 3> corners_;  ///< within it, scaled
    double square_ = 0;              ///< of the scaled radius
    std::optional<Impact> best_;
};

}  // namespace

std::optional<Impact> first_impact(const SweptBall& ball, const Corners3& from, const Corners3& to) {
    const SeenTriangle seen = seen_from(ball, from, to);
    const std::optional<Stretch> stretch = meeting_of_boxes(seen);
    if (!stretch) return std::nullopt;
    return ImpactSearch(seen, *stretch).first();
}

}  // namespace drape
