#pragma once

#include <Eigen/Core>
#include <array>

#include "drape/render/camera.h"
#include "drape/render/image.h"
#include "drape/sim/frame_view.h"
#include "holders.h"

namespace drape {

/// The shaders' block `Frame`, in the layout of std140.
struct FrameData {
    static constexpr int most_balls = 8;  ///< that darken their surroundings; any number is drawn

    Eigen::Matrix4f view_projection;
    Eigen::Matrix4f inverse_view_projection;
    Eigen::Matrix4f shadow_matrix;  ///< world to the shadow map's clip space
    Eigen::Vector4f eye;
    Eigen::Vector4f to_light;
    Eigen::Vector4f viewport;   ///< width, height [pixel] and their inverses, of what the scene is drawn into
    Eigen::Vector4f page;       ///< the same of the picture, for the panels
    Eigen::Vector4f stage;      ///< centre x, height of the ground, centre z, radius [m]
    Eigen::Vector4f shadow;     ///< a texel of the shadow map, the particles' spacing [m]; its part in a metre, twice
    Eigen::Vector4f magnified;  ///< x: pixels that the scene is drawn with for one that is shown on a usual display
    std::array<int, 4> counts;  ///< structural springs, shear springs, segments of a sphere's circle, balls that darken
    std::array<Eigen::Vector4f, most_balls> balls;  ///< centre, radius [m]
    std::array<Eigen::Vector4f, 9> node_colours;    ///< by `NodeState`
    std::array<Eigen::Vector4f, 9> value_colours;   ///< linear
    std::array<Eigen::Vector4f, 4> group_colours;   ///< linear
    std::array<int, 4> look;                     ///< groups: 1, sides: 2, else 0; the weave, the ground's grid: 1 or 0
    std::array<Eigen::Vector4f, 2> failure;      ///< where a run has diverged, two ends [m]; w: 0 if not shown
    std::array<Eigen::Vector4f, 2> mode_spring;  ///< likewise, of the unstable mode's spring
    std::array<int, 4> style;                    ///< number of the fabric, number of the palette
};

/// Where a particle is drawn: between its last two positions, if there are two [m].
Vec3 drawn_particle(const ClothView& cloth, Real blend, int particle);

/// Where a ball is drawn: centre and radius, between its last two positions.
Eigen::Vector4f drawn_ball(const FrameView& view, std::size_t number);

/// Where a solid is drawn: its position between the last two.
Eigen::Vector3f drawn_solid(const FrameView& view, std::size_t number);

/// The box about a solid where it is drawn.
Eigen::AlignedBox3f drawn_solid_box(const FrameView& view, std::size_t number, const Eigen::Matrix3f& axes);

/// How a ball is turned where it is drawn, between its last two orientations: x, y, z, w of a quaternion of length 1.
Eigen::Vector4f drawn_orientation(const FrameView& view, std::size_t number);

/// The block but for its `counts`.
/// @param drawn what the scene is drawn into, in the shape of the picture
/// @param holders of which the thick ones cast shadows too
/// @param display_scale as in `Panels`
FrameData make_frame_data(const FrameView& view, const Camera& camera, const PictureSize& picture,
                          const PictureSize& drawn, int shadow_texels, std::span<const Holder> holders = {},
                          double display_scale = 1);

}  // namespace drape
