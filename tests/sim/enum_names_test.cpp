// Names that files have: a renamed enumerator renames them.

#include <gtest/gtest.h>

#include "drape/scene/settings.h"

namespace drape {
namespace {

template <Enumeration Enum>
std::string all_names() {
    std::string all;
    for (const std::string& name : names_of<Enum>()) all += (all.empty() ? "" : " ") + name;
    return all;
}

TEST(EnumNames, AreThoseOfTheFilesThatThereAre) {
    EXPECT_EQ(all_names<IntegratorKind>(),
              "explicit_euler symplectic_euler velocity_verlet rk4 backward_euler implicit_midpoint bdf2 xpbd "
              "projective_dynamics dormand_prince");
    EXPECT_EQ(all_names<Hessian>(), "clamped exact");
    EXPECT_EQ(all_names<Kernels>(), "vector plain");
    EXPECT_EQ(all_names<OnUnstable>(), "warn substep stop");
    EXPECT_EQ(all_names<ResponseKind>(), "projection penalty impulse hybrid");
    EXPECT_EQ(all_names<Continuous>(), "auto true false");
    EXPECT_EQ(all_names<VolumeKind>(), "sphere aabb kdop6 kdop14 kdop18 kdop26 obb brute");
    EXPECT_EQ(all_names<UpdateKind>(), "rebuild merge insertion refit none");
    EXPECT_EQ(all_names<SphereFit>(), "centroid box ritter epos6 epos14 epos26 welzl");
    EXPECT_EQ(all_names<Plane>(), "xz xy");
    EXPECT_EQ(all_names<Pins::Kind>(), "none two four row border list");
    EXPECT_EQ(all_names<BallMotion>(), "keys path still free");
    EXPECT_EQ(all_names<SolidKind>(), "box capsule mesh");
    EXPECT_EQ(all_names<SolidMotion>(), "still path");
    EXPECT_EQ(all_names<PanelSize>(), "off compact full");
    EXPECT_EQ(all_names<ColourBy>(), "plain strain principal_strain speed depth level side difference");
    EXPECT_EQ(all_names<PictureQuality>(), "auto fast full");
    EXPECT_EQ(all_names<Fabric>(), "cotton silk denim plain");
    EXPECT_EQ(all_names<Palette>(), "studio dusk linen");
    EXPECT_EQ(all_names<NeedsMeasure>(), "positions centre_and_spread");
}

}  // namespace
}  // namespace drape
