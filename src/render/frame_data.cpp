#include "frame_data.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "cloth_colours.h"
#include "drape/session/unstable_mode.h"
#include "drawn_nodes.h"

namespace drape {

namespace {

const Eigen::Vector3f to_light = Eigen::Vector3f(-0.42f, 1.0f, 0.5f).normalized();

// The shadow map's edges lie on multiples of this, so that its texels do not crawl as the cloth moves [m]
constexpr float edge_step = 0.125f;

// Room around what casts, for the soft edges of its shadow [m]
constexpr float edge_room = 0.03f;

// Across the light, up across it, and along it
Eigen::Matrix3f light_axes() {
    const Eigen::Vector3f side = Eigen::Vector3f::UnitX().cross(to_light).cross(to_light).normalized();
    Eigen::Matrix3f axes;
    axes << side.transpose(), to_light.cross(side).transpose(), -to_light.transpose();
    return axes;
}

// What casts, as the light sees it: cloths, and of balls and solids those that are near them or near what the camera
// looks at. One that is far away would spread the map's texels over the way to it. What is farther towards the light
// may be outside of the box's depths; the vertex shader draws it at their start.
Eigen::AlignedBox3f casters(const FrameView& view, const Camera& camera, const Eigen::Matrix3f& axes) {
    Eigen::AlignedBox3f box;
    for (const ClothView& cloth : view.cloths) {
        const Points& x = cloth.x;
        for (Eigen::Index p = 0; p < x.rows(); ++p) box.extend(axes * Vec3(x.row(p)).cast<float>());
    }
    const Eigen::Vector3f room = Eigen::Vector3f::Constant(box.diagonal().norm());
    Eigen::AlignedBox3f near(box.min() - room, box.max() + room);
    const Eigen::Vector3f looked_at = axes * camera.target();
    const Eigen::Vector3f seen = Eigen::Vector3f::Constant(2 * (camera.eye() - camera.target()).norm());
    near.extend(Eigen::AlignedBox3f(looked_at - seen, looked_at + seen));
    const auto clamped = [&](Eigen::AlignedBox3f caster) {
        caster.min().z() = std::clamp(caster.min().z(), near.min().z(), near.max().z());
        caster.max().z() = std::clamp(caster.max().z(), near.min().z(), near.max().z());
        return caster;
    };
    for (std::size_t i = 0; i < view.balls.size(); ++i) {
        const Eigen::Vector4f ball = drawn_ball(view, i);
        const Eigen::Vector3f centre = axes * ball.head<3>();
        const Eigen::AlignedBox3f whole = clamped({centre.array() - ball.w(), centre.array() + ball.w()});
        if (near.intersects(whole)) box.extend(whole);
    }
    for (std::size_t i = 0; i < view.solids.size(); ++i) {
        const Eigen::AlignedBox3f part = clamped(drawn_solid_box(view, i, axes)).intersection(near);
        if (!part.isEmpty()) box.extend(part);
    }
    if (!box.sizes().allFinite()) return {Eigen::Vector3f::Constant(-1), Eigen::Vector3f::Constant(1)};
    return box;
}

void light_the_scene(const FrameView& view, const Camera& camera, std::span<const Holder> holders, int texels,
                     FrameData& data) {
    const Eigen::Matrix3f axes = light_axes();
    Eigen::AlignedBox3f box = casters(view, camera, axes);
    for (const Holder& holder : holders) {
        if (holder.radius < thinnest_caster) continue;
        box.extend(axes * holder.from);
        if (holder.ring == 0) box.extend(axes * holder.to);
    }
    const Eigen::Vector3f low = ((box.min().array() - edge_room) / edge_step).floor() * edge_step;
    const Eigen::Vector3f high = ((box.max().array() + edge_room) / edge_step).ceil() * edge_step;
    const Eigen::Vector3f middle = (low + high) / 2, half = (high - low) / 2;
    data.shadow_matrix.setIdentity();
    data.shadow_matrix.topLeftCorner<3, 3>() = half.cwiseInverse().asDiagonal() * axes;
    data.shadow_matrix.topRightCorner<3, 1>() = -middle.cwiseQuotient(half);
    data.to_light = {to_light.x(), to_light.y(), to_light.z(), 0};
    data.shadow = {2 * half.head<2>().maxCoeff() / static_cast<float>(texels), 0, 0.5f / half.x(), 0.5f / half.y()};
}

// A solid darkens what is about it like a ball in its middle. @return how many of them there are
int list_dark_balls(const FrameView& view, std::array<Eigen::Vector4f, FrameData::most_balls>& dark) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < view.balls.size() && count < dark.size(); ++i) dark[count++] = drawn_ball(view, i);
    for (std::size_t i = 0; i < view.solids.size() && count < dark.size(); ++i) {
        const std::array<Vec3, 2> extent = view.solids[i].shape->extent();
        dark[count++] << drawn_solid_box(view, i, Eigen::Matrix3f::Identity()).center(),
            static_cast<float>((extent[1] - extent[0]).minCoeff() / 2);
    }
    return static_cast<int>(count);
}

// From sRGB
Eigen::Vector4f linear(const std::array<float, 3>& colour) {
    const auto decoded = [](float c) { return c <= 0.04045f ? c / 12.92f : std::pow((c + 0.055f) / 1.055f, 2.4f); };
    return {decoded(colour[0]), decoded(colour[1]), decoded(colour[2]), 1};
}

// Two particles that are marked; zero if there are none
std::array<Eigen::Vector4f, 2> marked_ends(const FrameView& view, int cloth, const std::array<int, 2>& particles) {
    std::array<Eigen::Vector4f, 2> ends{Eigen::Vector4f::Zero(), Eigen::Vector4f::Zero()};
    if (cloth < 0 || cloth >= static_cast<int>(view.cloths.size())) return ends;
    const Points& x = view.cloths[static_cast<std::size_t>(cloth)].x;
    for (std::size_t end = 0; end < ends.size(); ++end) {
        if (particles[end] >= x.rows() || !x.row(particles[end]).allFinite()) return {ends[0] * 0, ends[1] * 0};
        ends[end] << x.row(particles[end]).transpose().cast<float>(), 1;
    }
    return ends;
}

Eigen::Vector4f sides_and_inverses(const PictureSize& size) {
    const auto width = static_cast<float>(size.width), height = static_cast<float>(size.height);
    return {width, height, 1 / width, 1 / height};
}

// Where one of several is drawn: between its last two places, if there are two
template <class Item>
Vec3 between(std::span<const Item> before, std::span<const Item> now, std::size_t number, Real blend,
             Vec3 Item::*place) {
    const Vec3& there = now[number].*place;
    if (number >= before.size()) return there;
    const Vec3& from = before[number].*place;
    return from + blend * (there - from);
}

}  // namespace

Vec3 drawn_particle(const ClothView& cloth, Real blend, int particle) {
    const Vec3 now = cloth.x.row(particle);
    if (cloth.previous.rows() != cloth.x.rows()) return now;
    const Vec3 before = cloth.previous.row(particle);
    return before + blend * (now - before);
}

Eigen::Vector4f drawn_ball(const FrameView& view, std::size_t number) {
    const Ball& now = view.balls[number];
    const Vec3 centre = between(view.previous_balls, view.balls, number, view.blend, &Ball::centre);
    Eigen::Vector4f ball;
    ball << centre.cast<float>(), static_cast<float>(now.radius);
    return ball;
}

Eigen::Vector3f drawn_solid(const FrameView& view, std::size_t number) {
    return between(view.previous_solids, view.solids, number, view.blend, &Solid::position).cast<float>();
}

Eigen::AlignedBox3f drawn_solid_box(const FrameView& view, std::size_t number, const Eigen::Matrix3f& axes) {
    const Solid& solid = view.solids[number];
    const std::array<Vec3, 2> extent = solid.shape->extent();
    const Eigen::Vector3f position = drawn_solid(view, number);
    Eigen::AlignedBox3f box;
    for (std::size_t corner = 0; corner < 8; ++corner) {
        const Vec3 own(extent[corner & 1].x(), extent[corner >> 1 & 1].y(), extent[corner >> 2].z());
        box.extend(axes * (position + (solid.orientation * own).cast<float>()));
    }
    return box;
}

Eigen::Vector4f drawn_orientation(const FrameView& view, std::size_t number) {
    Eigen::Quaternion<Real> orientation = view.balls[number].orientation;
    if (number < view.previous_balls.size()) {
        orientation = view.previous_balls[number].orientation.slerp(view.blend, orientation);
    }
    return orientation.coeffs().cast<float>();
}

FrameData make_frame_data(const FrameView& view, const Camera& camera, const PictureSize& picture,
                          const PictureSize& drawn, int shadow_texels, std::span<const Holder> holders,
                          double display_scale) {
    FrameData data{};
    data.viewport = sides_and_inverses(drawn);
    data.page = sides_and_inverses(picture);
    data.magnified.x() = static_cast<float>(display_scale) * data.viewport.y() / data.page.y();
    const float aspect = data.page.x() / data.page.y();
    data.view_projection = camera.projection_matrix(aspect) * camera.view_matrix();
    data.inverse_view_projection = data.view_projection.inverse();
    data.eye = camera.eye().homogeneous();

    light_the_scene(view, camera, holders, shadow_texels, data);

    // The stage lies about what the scene looks at
    const ViewSettings& settings = view.settings->view;
    const Vec3 target = settings.target;
    const auto distance = static_cast<float>((settings.eye - settings.target).norm());
    data.stage << static_cast<float>(target.x()), static_cast<float>(view.settings->ground.height),
        static_cast<float>(target.z()), std::max(0.5f, distance);

    const auto colour_of = [](const LineLook& look) { return Eigen::Vector4f(look.colour.data()); };
    std::ranges::transform(node_looks, data.node_colours.begin(), colour_of);
    // Their lines are a pixel wide at least; those that are magnified are fainter instead
    for (Eigen::Vector4f& colour : data.node_colours) colour.w() *= std::min(data.magnified.x(), 1.0f);
    std::ranges::transform(value_colours, data.value_colours.begin(), linear);
    std::ranges::transform(group_colours, data.group_colours.begin(), linear);
    const ColourBy by = settings.colour;
    const int groups = by == ColourBy::Level ? 1 : by == ColourBy::Side ? 2 : 0;
    const bool woven = settings.weave && settings.fabric != Fabric::Plain;
    data.look = {groups, woven ? 1 : 0, settings.grid ? 1 : 0, 0};
    data.style = {static_cast<int>(settings.fabric), static_cast<int>(settings.palette), 0, 0};

    // The first particle that has diverged, and the other end of its spring
    const FailureSpot spot = view.report->status == Status::Ok ? FailureSpot{} : view.report->failure;
    data.failure = marked_ends(view, spot.cloth, {spot.particle, spot.other < 0 ? spot.particle : spot.other});
    data.mode_spring = view.mode == nullptr ? marked_ends(view, -1, {})
                                            : marked_ends(view, static_cast<int>(view.mode->cloth), view.mode->spring);

    data.counts = {0, 0, 0, list_dark_balls(view, data.balls)};
    return data;
}

}  // namespace drape
