#include "render/picture_target.h"

#include <gtest/gtest.h>

#include "drape/render/camera.h"

namespace drape {
namespace {

constexpr int width = 400, height = 300;

Eigen::Matrix4f matrix() {
    const Camera camera{ViewSettings()};
    return camera.projection_matrix(float(width) / height) * camera.view_matrix();
}

PictureBox box_of(const Vec3& point) {
    const Eigen::Vector3f p = point.cast<float>();
    PictureBounds bounds(matrix(), width, height);
    bounds.add(p);
    return bounds.box();
}

TEST(PictureBox, IsAroundThePixelOfAParticle) {
    const Camera camera{ViewSettings()};
    for (const auto& [x, y] : {std::pair{200, 150}, {30, 40}, {399, 299}, {0, 0}}) {
        const Ray ray = camera.ray(x, y, width, height);
        const PictureBox box = box_of(ray.origin + 2 * ray.direction);
        const int row = height - 1 - y;
        EXPECT_LE(box.left, x);
        EXPECT_LE(box.low, row);
        EXPECT_GT(box.left + box.width, x);
        EXPECT_GT(box.low + box.height, row);
        EXPECT_LE(box.width, 4);
        EXPECT_LE(box.height, 4);
    }
}

TEST(PictureBox, IsAroundTheWholeBall) {
    const Camera camera{ViewSettings()};
    const Ray ray = camera.ray(width / 2, height / 2, width, height);
    const Vec3 centre = ray.origin + 2 * ray.direction;
    PictureBounds bounds(matrix(), width, height);
    bounds.add(centre.cast<float>(), 0.2f);
    const PictureBox box = bounds.box();
    const PictureBox side = box_of(centre + Real(0.2) * camera.right());
    EXPECT_LE(box.left + box.width, width);
    EXPECT_GE(box.left + box.width, side.left + side.width - 1);
    EXPECT_LE(box.left, width - side.left);
}

TEST(PictureBox, IsTheWholePictureIfSomethingIsBehindTheEyeAndEmptyIfThereIsNothing) {
    const Camera camera{ViewSettings()};
    const Ray ray = camera.ray(width / 2, height / 2, width, height);
    const PictureBox all = box_of(ray.origin - ray.direction), none = PictureBounds(matrix(), width, height).box();
    EXPECT_TRUE(all.left == 0 && all.low == 0 && all.width == width && all.height == height);
    EXPECT_TRUE(none.width == 0 && none.height == 0);
}

}  // namespace
}  // namespace drape
