// The weave is on the cloth and a grid on the ground; pins hang from something, and what the hand holds is marked where
// it is.

#include <gtest/gtest.h>

#include <cmath>

#include "drawn_scene.h"
#include "expected_picture.h"

namespace drape::test {
namespace {

constexpr int look_width = 1280, look_height = 720;

struct LookPicture : DrawnScene, testing::Test {
    explicit LookPicture(const char* scene = "drop") : DrawnScene(scene) {}

    [[nodiscard]] Image draw(const ClothView& cloth) const {
        FrameView changed = view;
        changed.cloths = {&cloth, 1};
        return picture_of(changed, look_width, look_height);
    }
};

TEST_F(LookPicture, HasAWeaveOnTheClothAlone) {
    settings.view.weave = false;
    const Image plain = draw(cloth());
    settings.view.weave = true;
    const Image woven = draw(cloth());
    const ExpectedPicture expected(view, look_width, look_height);
    int on_cloth = 0, elsewhere = 0;
    for (int y = 0; y < look_height; ++y) {
        for (int x = 0; x < look_width; ++x) {
            if (std::abs(brightness_at(plain, x, y) - brightness_at(woven, x, y)) < 6) continue;
            on_cloth += expected.surely(Seen::Front, x, y, 1);
            elsewhere += expected.surely(Seen::Nothing, x, y, 2);
        }
    }
    EXPECT_GT(on_cloth, 1000);
    EXPECT_EQ(elsewhere, 0);
}

TEST_F(LookPicture, OfAPlainFabricHasNoWeave) {
    settings.view.fabric = Fabric::Plain;
    const Image with = draw(cloth());
    settings.view.weave = false;
    EXPECT_EQ(with.rgb, draw(cloth()).rgb);
}

/// Seen on edge, where its sides are a line without width, the cloth is as thick as for its contacts.
TEST_F(LookPicture, IsAsThickOnEdgeAsForContacts) {
    settings.view.eye = Vec3(0, 0.65, 2);
    settings.view.target = Vec3(0, 0.65, 0);
    const auto rows = [&](Real thickness) {
        settings.contact.thickness = thickness;
        settings.view.smooth = false;
        const Image without = draw(cloth());
        settings.view.smooth = true;
        const Image with = draw(cloth());
        int changed = 0;
        for (int y = 0; y < look_height; ++y) {
            changed +=
                std::abs(brightness_at(with, look_width / 2, y) - brightness_at(without, look_width / 2, y)) > 60;
        }
        return changed;
    };
    const int thin = rows(0.01);
    EXPECT_GT(thin, 2);
    EXPECT_NEAR(rows(0.04), 4 * thin, 4);
}

struct GroundGrid : LookPicture {
    /// How much darker the ground is on its lines than between them, where they are expected `aside` along x [m].
    double contrast(double aside) {
        settings.view.grid = true;
        const Image with = draw(cloth());
        settings.view.grid = false;
        const Image without = draw(cloth());
        const ExpectedPicture expected(view, look_width, look_height);
        const auto darker = [&](double x, double z) {
            const auto place = expected.project({Real(x), settings.ground.height, Real(z)});
            const int i = static_cast<int>(place.x), j = static_cast<int>(place.y);
            if (!expected.surely(Seen::Nothing, i, j, 3)) return 0.0;
            double most = 0;
            for (int down = -1; down <= 1; ++down) {
                for (int right = -1; right <= 1; ++right) {
                    most = std::max(most, 1 - brightness_at(with, i + right, j + down) /
                                                  brightness_at(without, i + right, j + down));
                }
            }
            return most;
        };
        double sum = 0;
        int points = 0;
        for (int line = -4; line <= 4; ++line) {
            for (int row = 0; row < 8; ++row, ++points) {
                const double x = 0.1 * line + aside, z = 0.1 * row + 0.05;
                sum += darker(x, z) - darker(x + 0.05, z);
            }
        }
        return sum / points;
    }
};

TEST_F(GroundGrid, HasALineEveryTenCentimetres) {
    EXPECT_GT(contrast(0), 0.004);
    EXPECT_LT(contrast(0.05), 0) << "aside by half of that";
}

struct Pinned : LookPicture {
    Pinned() : LookPicture("hang") {}

    /// Pixels that differ, near the particles or above them, and elsewhere.
    struct Difference {
        int near = 0, elsewhere = 0;
    };
    [[nodiscard]] Difference difference(const Image& a, const Image& b, std::span<const int> particles) const {
        const ExpectedPicture expected(view, look_width, look_height);
        Difference found;
        for (int y = 0; y < look_height; ++y) {
            for (int x = 0; x < look_width; ++x) {
                if (std::abs(brightness_at(a, x, y) - brightness_at(b, x, y)) < 20) continue;
                const bool near = std::ranges::any_of(particles, [&](int particle) {
                    const Vec3 pin = cloth().x.row(particle).transpose();
                    const auto place = expected.project(pin), above = expected.project(pin + Vec3(0, 1, 0));
                    const double part = std::max(0.0, (y - place.y) / (above.y - place.y));
                    return std::hypot(x - place.x - part * (above.x - place.x), std::max(y - place.y, 0.0)) < 16;
                });
                ++(near ? found.near : found.elsewhere);
            }
        }
        return found;
    }
};

TEST_F(Pinned, ParticlesHangFromCordsAndNoOthers) {
    const ClothView& shown = cloth();
    std::vector<int> pinned;
    ClothModel free = shown.model;
    for (int p = 0; p < shown.model.grid.particles(); ++p) {
        if (!shown.model.pinned(p)) continue;
        pinned.push_back(p);
        free.inverse_mass[p] = 1;
    }
    ASSERT_FALSE(pinned.empty());
    const Image with = draw(shown);
    const ClothView without{free, shown.x, shown.previous, {}, shown.hierarchy};
    for (const int p : pinned) EXPECT_GT(difference(with, draw(without), {&p, 1}).near, 8) << p;
    EXPECT_EQ(difference(with, draw(without), pinned).elsewhere, 0);
}

TEST_F(Pinned, ParticleInTheHandHasARing) {
    ClothView touched = cloth();
    const Image without = draw(touched);
    const int grabbed = touched.model.grid.particle(touched.model.grid.nx / 2, touched.model.grid.ny / 2);
    ClothModel led = touched.model;
    led.hold(grabbed, true);
    ClothView in_hand{led, touched.x, touched.previous, {}, touched.hierarchy};
    in_hand.grabbed = grabbed;
    const Difference found = difference(draw(in_hand), without, {&grabbed, 1});
    EXPECT_GT(found.near, 100);
    EXPECT_EQ(found.elsewhere, 0);
}

}  // namespace
}  // namespace drape::test
