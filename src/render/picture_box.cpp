#include "picture_box.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace drape {

namespace {

// The corners of the picture are (-1, -1) and (1, 1)
class Projection {
public:
    explicit Projection(const Eigen::Matrix4f& matrix) : matrix_(matrix) {}

    void add(const Eigen::Vector3f& point) {
        constexpr float nearest = 1e-3f;  // m before the eye
        const Eigen::Vector4f clip = matrix_ * point.homogeneous();
        if (!(clip.w() > nearest)) {
            box_.extend(Eigen::Vector2f(-1, -1)).extend(Eigen::Vector2f(1, 1));
        } else {
            box_.extend(Eigen::Vector2f(clip.head<2>() / clip.w()));
        }
    }

    [[nodiscard]] Eigen::AlignedBox2f box() const { return box_; }

private:
    Eigen::Matrix4f matrix_;
    Eigen::AlignedBox2f box_;
};

}  // namespace

PictureBox solid_box(const Eigen::Matrix4f& view_projection, std::span<const ClothVertex> cloth,
                     std::span<const Eigen::Vector4f> balls, int width, int height) {
    Projection projection(view_projection);
    for (const ClothVertex& vertex : cloth) projection.add(Eigen::Map<const Eigen::Vector3f>(vertex.position));
    for (const Eigen::Vector4f& ball : balls) {
        for (int corner = 0; corner < 8; ++corner) {
            const Eigen::Vector3f side(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
            projection.add(ball.head<3>() + ball.w() * side);
        }
    }
    if (projection.box().isEmpty()) return {};

    // Whole pixels, and one around them for what is smoothed
    const auto edge = [](float place, int size, int room) {
        const float pixel = std::floor((std::clamp(place, -1.0f, 1.0f) * 0.5f + 0.5f) * static_cast<float>(size));
        return std::clamp(static_cast<int>(pixel) + room, 0, size);
    };
    const Eigen::Vector2f least = projection.box().min(), most = projection.box().max();
    const int left = edge(least.x(), width, -1), low = edge(least.y(), height, -1);
    return {left, low, edge(most.x(), width, 2) - left, edge(most.y(), height, 2) - low};
}

}  // namespace drape
