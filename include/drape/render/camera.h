#pragma once

#include <Eigen/Core>

#include "drape/sim/command.h"
#include "drape/sim/frame_view.h"

namespace drape {

/// A point and direction in the scene; the direction has length 1.
struct Ray {
    Vec3 origin;
    Vec3 direction;
};

/// A perspective camera that orbits a target. Angles in radians, lengths in metres.
class Camera {
public:
    /// Looks from `view.eye` to `view.target`.
    explicit Camera(const ViewSettings& view);

    /// Orbit, pan, zoom and frame, no farther than the scene reaches and above solid ground; home. Every other command
    /// passes by.
    void apply(const Command& command, const FrameView& view);

    /// Moves towards what another camera shows, so that 63 % of the way is made in 0.1 s, however long the frames are;
    /// what is left of it, once nobody would see it, at once.
    /// @param elapsed since the last call [s]
    /// @return false if it is there already, and equal to it
    bool ease_towards(const Camera& goal, double elapsed);

    bool operator==(const Camera&) const = default;

    [[nodiscard]] Eigen::Vector3f eye() const;
    [[nodiscard]] Eigen::Vector3f target() const { return target_; }
    [[nodiscard]] Eigen::Matrix4f view_matrix() const;
    /// @param aspect width over height of the picture
    [[nodiscard]] Eigen::Matrix4f projection_matrix(float aspect) const;

    /// The ray through a pixel, (0, 0) at the top left.
    [[nodiscard]] Ray ray(int x, int y, int width, int height) const;

    /// Whether a picture shows any of a ball, if nothing is before it.
    /// @param aspect width over height of the picture
    [[nodiscard]] bool sees(const Ball& ball, float aspect) const;

    /// A ball that flies from a point on the line of sight, before the viewer, about to where the line of sight leads.
    [[nodiscard]] command::Throw aimed_throw() const;

    /// The point where a ray meets the plane through `through` that faces the camera: how a dragged hand moves.
    [[nodiscard]] Vec3 on_facing_plane(const Ray& ray, const Vec3& through) const;

    /// Unit vectors for steering the ball: to the right and away from the viewer, both horizontal.
    [[nodiscard]] Vec3 right() const;
    [[nodiscard]] Vec3 ahead() const;

private:
    Eigen::Vector3f target_;
    float yaw_, pitch_, distance_;
};

/// The particle of a cloth that a ray hits first, through the triangle it hits; `particle` is -1 if it hits none or a
/// ball is before it.
struct Pick {
    int cloth = 0;
    int particle = -1;
    Vec3 point = Vec3::Zero();
    int ball = -1;                  ///< that it hits in place of cloth; -1: none
    Vec3 to_centre = Vec3::Zero();  ///< of the ball, from the point; of cloth zero
};
Pick pick_particle(const FrameView& view, const Ray& ray);

}  // namespace drape
