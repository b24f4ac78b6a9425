#include <gmock/gmock.h>

#include "drape/sim/scene.h"
#include "drape/sim/start.h"
#include "sim/scene_lists.h"

namespace drape {
namespace {

using testing::HasSubstr;

TEST(StepWarning, IsNotNeededForTheShippedScenes) {
    for (const std::string& name : scenes_that_fail(false)) EXPECT_EQ(step_warning(load_scene(name)), "") << name;
}

TEST(StepWarning, NamesStepMethodAndLimit) {
    Settings settings = load_scene("drop");
    settings.solver.dt = Real(0.01);
    const std::string warning = step_warning(settings);
    EXPECT_THAT(warning, HasSubstr("solver.dt = 0.0"));
    EXPECT_THAT(warning, HasSubstr("symplectic_euler is stable on this cloth up to about 0.000"));
}

TEST(StepWarning, SaysThatExplicitEulerNeedsDamping) {
    EXPECT_THAT(step_warning(load_scene("fails_explicit_euler")), HasSubstr("with no step"));
}

TEST(StepWarning, LooksAtEveryCloth) {
    Settings settings = load_scene("drop");
    settings.cloths.push_back(settings.cloths.front());
    settings.cloths.back().mass /= 100;
    EXPECT_NE(step_warning(settings), "");
}

}  // namespace
}  // namespace drape
