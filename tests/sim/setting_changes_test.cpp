#include <gmock/gmock.h>

#include "drape/scene/setting_table.h"
#include "support/input_errors.h"

namespace drape {
namespace {

using test::input_error_of;
using testing::AllOf;
using testing::HasSubstr;

Settings with_balls(std::size_t count) {
    Settings settings;
    settings.balls.resize(count);
    return settings;
}

TEST(Assignment, SetsAllClothsAndBallsOrTheOneNamed) {
    Settings settings = with_balls(3);
    assign(settings, "ball.radius=0.5");
    assign(settings, "ball[1].radius=0.25");
    EXPECT_EQ(settings.balls[0].radius, 0.5);
    EXPECT_EQ(settings.balls[1].radius, 0.25);
    EXPECT_EQ(settings.balls[2].radius, 0.5);
}

TEST(Assignment, RefusesAnIndexThatIsNotThere) {
    Settings settings = with_balls(2);
    EXPECT_THAT(input_error_of([&] { assign(settings, "ball[2].radius=0.5"); }),
                AllOf(HasSubstr("ball[2]"), HasSubstr("the scene has 2")));
    for (const char* name : {"ball[-1].radius", "ball[].radius", "ball[x].radius", "ball[99999999999999999999].radius",
                             "ball]1[.radius", "solver[1].dt", "ball[0]radius", "[0].radius"}) {
        EXPECT_THROW(assign(settings, std::string(name) + "=0.5"), InputError) << name;
        EXPECT_THROW(with_added(settings, name, 0.1), InputError) << name;
        EXPECT_THROW(with_next(settings, name), InputError) << name;
    }
}

TEST(Assignment, SaysThatASceneHasNoBall) {
    Settings settings;
    EXPECT_THAT(input_error_of([&] { assign(settings, "ball.radius=0.5"); }), HasSubstr("the scene has no ball"));
    EXPECT_THAT(input_error_of([&] { with_next(settings, "ball.motion"); }), HasSubstr("the scene has no ball"));
    EXPECT_THAT(input_error_of([&] { with_added(settings, "ball.radius", 1); }), HasSubstr("the scene has no ball"));
}

TEST(Assignment, NeedsANameAndAValueOfItsKindAndChangesNothingWithoutThem) {
    Settings settings = with_balls(2);
    for (const char* text :
         {"", "=", "=5", "solver.dt", "solver.dt=", "solver.dt= ", "solver.dt=x", "ball.position=1]2,3,4",
          "ball.position=[1,2,3", "ball.position=1,2,3]", "ball.position=]1,2,3[", "ball.position=1,,3",
          "ball.position=1 2,3,4", "ball.position=1,2,3,", "ball.position=[[]]", "title=one\ntwo", "ball.radius=-1",
          // Bad numbers among good ones, fractions, and lists of another length
          "cloth.particles=4,nan", "cloth.size=1,0", "ball.position=0,0,1e5", "cloth.pinned=0,-1",
          "cloth.particles=1,8", "cloth.particles=8,1", "contact.leaf_cells=4.5", "cloth.particles=4.5,4",
          "cloth.pinned=1.5", "cloth.particles=4", "cloth.particles=4,4,4", "cloth.size=[]", "ball.position=1,2",
          "ball.path=1,2,3", "cloth.origin=", "ball.position=[nan, nan]", "solver.dt=inf"}) {
        EXPECT_THROW(assign(settings, text), InputError) << '"' << text << '"';
    }
    EXPECT_EQ(settings.balls, with_balls(2).balls);
    assign(settings, "title=Seide im Wind: \xc3\xbc");
    EXPECT_EQ(settings.title, "Seide im Wind: \xc3\xbc");
}

TEST(Assignment, NamesValueAndRangeInAShortMessage) {
    Settings settings;
    EXPECT_EQ(input_error_of([&] { assign(settings, "dt=5"); }), "solver.dt = 5: allowed 1e-09 <= dt <= 0.1 s");
    EXPECT_THAT(input_error_of([&] { assign(settings, "volume=cube"); }),
                AllOf(HasSubstr("cube"), HasSubstr("'sphere'")));
    for (const std::string name : {"dt", "integrator", "cloth.pinned", "wind.on"}) {
        const std::string message = input_error_of([&] { assign(settings, name + "=" + std::string(100'000, '9')); });
        EXPECT_NE(message, "");
        EXPECT_LT(message.size(), 400u);
    }
}

TEST(Assignment, ReadsListsWithAndWithoutBrackets) {
    Settings settings = with_balls(1);
    for (const char* text : {"1,2,3", "[1, 2, 3]", " [ 1 ,2,\t3 ] "}) {
        settings.balls[0].position.setZero();
        assign(settings, std::string("ball.position=") + text);
        EXPECT_EQ(settings.balls[0].position, Vec3(1, 2, 3)) << text;
    }
    assign(settings, "ball.path=[[0, 1, 2, 3], [1, 4, 5, 6]]");
    ASSERT_EQ(settings.balls[0].path.size(), 2u);
    EXPECT_EQ(settings.balls[0].path[1], (PathPoint{1, Vec3(4, 5, 6)}));
    assign(settings, "cloth.pinned=[]");
    EXPECT_EQ(settings.cloths[0].pinned, (Pins{Pins::Kind::List, {}}));
}

TEST(Assignments, OfACommandLineNameTheOption) {
    Settings settings;
    const std::vector<std::string> words{"friction=0.7", "dt=7"};
    EXPECT_THAT(input_error_of([&] { assign_all(settings, words); }), HasSubstr("--set dt=7: solver.dt = 7: allowed"));
    EXPECT_EQ(settings.contact.friction, 0.7);
}

TEST(NextValue, GoesThroughEveryChoiceAndBack) {
    for (const Setting& setting : setting_table()) {
        if (setting.kind != SettingKind::Choice) continue;
        Settings settings = with_balls(1);
        settings.solids.emplace_back();
        assign(settings, setting.full_name() + "=" + setting.choices[0]);
        for (std::size_t i = 0; i < 2 * setting.choices.size(); ++i) {
            EXPECT_EQ(std::get<std::string>(setting.read(settings, 0)), setting.choices[i % setting.choices.size()])
                << setting.full_name();
            settings = with_next(settings, setting.full_name());
        }
    }
    const Settings settings;
    EXPECT_TRUE(with_next(settings, "wind.on").wind.on);
    EXPECT_FALSE(with_next(with_next(settings, "wind.on"), "wind.on").wind.on);
    EXPECT_THROW(with_next(settings, "solver.dt"), InputError);
}

TEST(AddedAmount, StaysInTheRange) {
    const Settings settings;
    EXPECT_EQ(with_added(settings, "view.level", 2).view.level, 5);
    EXPECT_EQ(with_added(settings, "view.level", -100).view.level, 0);
    EXPECT_EQ(with_added(settings, "view.level", 1e9).view.level, 30);
    EXPECT_EQ(with_added(settings, "solver.dt", -1).solver.dt, 1e-9);
    EXPECT_EQ(with_added(settings, "solver.dt", 1).solver.dt, 0.1);
    EXPECT_THROW(with_added(settings, "solver.dt", std::numeric_limits<double>::quiet_NaN()), InputError);
    EXPECT_THROW(with_added(settings, "wind.on", 1), InputError);
    EXPECT_THROW(with_added(settings, "wind.velocity", 1), InputError);
}

TEST(AddedAmount, IsAddedToEachBallsOwnValue) {
    Settings settings = with_balls(2);
    settings.balls[0].radius = 1;
    settings.balls[1].radius = 2;
    const Settings all = with_added(settings, "ball.radius", 0.5), one = with_added(settings, "ball[1].radius", 0.5);
    EXPECT_EQ(all.balls[0].radius, 1.5);
    EXPECT_EQ(all.balls[1].radius, 2.5);
    EXPECT_EQ(one.balls[0].radius, 1);
    EXPECT_EQ(one.balls[1].radius, 2.5);
}

TEST(SettingsTogether, FitIntoMemory) {
    Settings settings;
    assign(settings, "cloth.particles=2000,2000");
    EXPECT_NO_THROW(check(settings));
    assign(settings, "cloth.particles=2001,2000");
    EXPECT_THAT(input_error_of([&] { check(settings); }), HasSubstr("at most 4000000"));
    assign(settings, "cloth.particles=1500,1500");
    settings.cloths.push_back(settings.cloths[0]);
    EXPECT_THROW(check(settings), InputError) << "two cloths count together";
}

}  // namespace
}  // namespace drape
