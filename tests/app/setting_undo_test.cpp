#include "../../src/app/setting_undo.h"

#include <gmock/gmock.h>

#include "drape/scene/scene.h"

namespace drape {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// Settings that a user changes.
struct User {
    Settings settings = load_scene("three_balls");
    SettingUndo undo;
    std::int64_t step = 0;

    void set(const std::string& assignment, int press = 0) {
        const std::string name = assignment.substr(0, assignment.find('='));
        auto before = assignments_of(settings, name);
        assign(settings, assignment);
        undo.changed(++step, name, std::move(before), assignments_of(settings, name), press);
    }
    SettingUndo::Assignments carry_out(const SettingUndo::Assignments& assignments) {
        assign_all(settings, assignments);
        return assignments;
    }
    SettingUndo::Assignments back() { return carry_out(undo.next(false, settings, ++step).assignments); }
    SettingUndo::Assignments forth() { return carry_out(undo.next(true, settings, ++step).assignments); }
};

TEST(SettingUndo, GoesBackToWhereItBeganAndForthAgain) {
    User user;
    const SettingUndo::Assignments radii = assignments_of(user.settings, "ball.radius");
    ASSERT_EQ(radii.size(), 4u);
    user.set("contact.friction=0.7");
    user.set("ball.radius=0.1");
    user.set("ball[1].radius=0.2");
    EXPECT_THAT(user.back(), ElementsAre("ball[1].radius=0.1"));
    EXPECT_EQ(user.back(), radii) << "each has its own again";
    EXPECT_THAT(user.forth(),
                ElementsAre("ball[0].radius=0.1", "ball[1].radius=0.1", "ball[2].radius=0.1", "ball[3].radius=0.1"));
    user.set("contact.friction=0.8");
    EXPECT_THAT(user.forth(), IsEmpty()) << "a new change forgets what was taken back";
    EXPECT_THAT(user.back(), ElementsAre("contact.friction=0.7"));
    user.back();
    user.back();
    EXPECT_THAT(user.back(), IsEmpty());
    EXPECT_EQ(assignments_of(user.settings, "contact.friction"),
              assignments_of(load_scene("three_balls"), "contact.friction"));
}

TEST(SettingUndo, TakesADragForOneChange) {
    User user;
    const SettingUndo::Assignments before = assignments_of(user.settings, "contact.friction");
    for (const char* friction : {"0.5", "0.6", "0.7"}) user.set(std::string("contact.friction=") + friction, 1);
    user.set("contact.friction=0.8", 2);
    EXPECT_THAT(user.back(), ElementsAre("contact.friction=0.7"));
    EXPECT_EQ(user.back(), before);
    EXPECT_THAT(user.forth(), ElementsAre("contact.friction=0.7"));
}

TEST(SettingUndo, KnowsWhenAChangeWasMadeLast) {
    User user;
    user.set("contact.friction=0.7");
    const std::int64_t first = user.step;
    EXPECT_EQ(user.undo.next(false, user.settings, 500).step, first);
    assign(user.settings, "contact.friction=0.1");
    user.undo.next(true, user.settings, 900);
    EXPECT_EQ(user.undo.next(false, user.settings, 1000).step, 900);
}

TEST(SettingUndo, PassesOverWhatIsSoAlready) {
    User user;
    user.set("contact.restitution=0.5");
    user.set("contact.friction=0.7");
    assign(user.settings, assignments_of(load_scene("three_balls"), "contact.friction").front());
    EXPECT_EQ(user.back(), assignments_of(load_scene("three_balls"), "contact.restitution"))
        << "the user has gone back in time";
}

}  // namespace
}  // namespace drape
