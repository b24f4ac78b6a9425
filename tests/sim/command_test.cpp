#include "drape/sim/command.h"

#include <gmock/gmock.h>

#include <set>

#include "drape/base/input_error.h"
#include "support/input_errors.h"

namespace drape {
namespace {

using test::input_error_of;
using testing::AllOf;
using testing::HasSubstr;

/// One command of every kind, in the order of the variant.
std::vector<Command> one_of_each() {
    using namespace command;
    return {Pause{},
            Step{12},
            Reset{},
            LoadScene{"my scenes/drop 2.toml"},
            Load{"runs/a b.snapshot"},
            Compare{"ball.position=1,2,3,solver.integrator=xpbd"},
            Set{"ball.position=[1, 2, 3]"},
            Next{"ball[1].motion"},
            Add{"view.level", -1.5},
            Steer{Vec3(1, 0, -0.1)},
            Throw{Vec3(0.5, 1, -2), Vec3(0, 1.5, -6)},
            Fall{},
            Grab{1, 17},
            Hold{2},
            Drag{Vec3(0.1, 1e-300, -2e8)},
            Release{},
            Pin{1, 17},
            Orbit{0.1, 1.0 / 3},
            Pan{-0.25, 1e-17},
            Zoom{0.9},
            Frame{},
            Home{},
            Picture{},
            Video{},
            Quit{}};
}

TEST(Command, OfEveryKindReadsBackFromItsText) {
    const std::vector<Command> commands = one_of_each();
    ASSERT_EQ(commands.size(), std::variant_size_v<Command>);
    std::set<std::string> texts;
    for (std::size_t i = 0; i < commands.size(); ++i) {
        ASSERT_EQ(commands[i].index(), i);
        const std::string text = command_text(commands[i]);
        const Command again = parse_command(text);
        EXPECT_EQ(again.index(), i) << text;
        EXPECT_EQ(command_text(again), text);
        EXPECT_TRUE(texts.insert(text).second);
    }
}

TEST(Command, CompareNoneEndsAComparison) {
    const Command command = parse_command("compare none");
    EXPECT_FALSE(std::get<command::Compare>(command).begins());
    EXPECT_EQ(command_text(command), "compare none");
    EXPECT_TRUE(std::get<command::Compare>(parse_command("compare contact.friction=0.7")).begins());
    EXPECT_THAT(input_error_of([] { parse_command("compare"); }), HasSubstr("'compare NAME=VALUE,... | none'"));
}

TEST(Command, KeepsItsArgumentsToTheLastBit) {
    EXPECT_EQ(std::get<command::Set>(parse_command("set  ball.position=[1, 2, 3]")).assignment,
              "ball.position=[1, 2, 3]");
    EXPECT_EQ(std::get<command::LoadScene>(parse_command("scene a b.toml")).name, "a b.toml");
    const auto grab = std::get<command::Grab>(parse_command("grab 1 17"));
    EXPECT_EQ(grab.cloth, 1);
    EXPECT_EQ(grab.particle, 17);
    const auto add = std::get<command::Add>(parse_command("add view.level -1.5 "));
    EXPECT_EQ(add.setting, "view.level");
    EXPECT_EQ(add.amount, -1.5);
    const auto orbit = std::get<command::Orbit>(parse_command("orbit\t0.1 -0.2"));
    EXPECT_EQ(orbit.yaw, 0.1);
    EXPECT_EQ(orbit.pitch, -0.2);
}

TEST(Command, WithWrongArgumentsIsRefusedWithItsForm) {
    const char* const wrong[] = {"pause 1",       "step",   "step -1",   "step 1.5",   "step 99999999999", "step 1 2",
                                 "scene ",        "set",    "next a b",  "add x",      "add view.level x", "steer 1 0",
                                 "steer nan 0 0", "grab 0", "grab -1 0", "grab 0 1.5", "drag 1e300 0 0",   "release 1",
                                 "orbit 1",       "pan 1",  "zoom nan",  "frame 1",    "picture x",        "quit now"};
    for (const char* text : wrong) {
        EXPECT_THAT(input_error_of([&] { parse_command(text); }),
                    AllOf(HasSubstr("command '"), HasSubstr("expected '")))
            << text;
    }
    EXPECT_THAT(input_error_of([] { parse_command("grab 0"); }), HasSubstr("'grab CLOTH PARTICLE'"));
}

TEST(Command, ThatIsUnknownNamesTheNearestOne) {
    EXPECT_THAT(input_error_of([] { parse_command("paus"); }), AllOf(HasSubstr("'paus'"), HasSubstr("'pause'")));
    for (const char* text : {"", " ", " pause", "\n", "hash 00"}) EXPECT_THROW(parse_command(text), InputError) << text;
    EXPECT_LT(input_error_of([] { parse_command(std::string(100'000, 'x')); }).size(), 300u);
}

TEST(Command, ConcernsTheStateOrThePictureOnly) {
    const std::set<std::string> picture_only{"orbit", "pan", "zoom", "frame", "home", "picture", "video", "quit"};
    for (const Command& command : one_of_each()) {
        const std::string text = command_text(command), name = text.substr(0, text.find(' '));
        EXPECT_EQ(changes_state(command), !picture_only.contains(name)) << name;
    }
}

}  // namespace
}  // namespace drape
