#include "drape/scene/start_state.h"

#include <gmock/gmock.h>

#include <cmath>
#include <sstream>

#include "drape/scene/scene.h"
#include "drape/session/state_csv.h"
#include "sim/small_scene.h"
#include "support/input_errors.h"
#include "support/scratch_file.h"

namespace drape {
namespace {

using testing::HasSubstr;

TEST(StartState, GoesOnWhereAnotherRunHasLeftOff) {
    const test::ScratchFile file("state.csv");
    Simulation whole = small_simulation({"sleep_speed=0"});
    std::ostringstream moments;
    write_state_header(moments, whole);
    for (const int steps : {100, 50}) {
        make_steps(whole, steps);
        write_state(moments, whole);
    }
    // The last moment counts; ends of lines may be those of other systems
    std::string text = moments.str();
    for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2) text.replace(at, 1, "\r\n");
    file.write(text);
    Simulation rest = small_simulation({"sleep_speed=0", "start=" + file.name()});
    EXPECT_EQ(rest.report().time, whole.report().time);
    EXPECT_EQ(rest.hash(), whole.hash());
    make_steps(whole, 100), make_steps(rest, 100);
    EXPECT_EQ(rest.hash(), whole.hash());
    rest.apply(command::Reset{});
    EXPECT_DOUBLE_EQ(rest.report().time, 150.0 / 1024) << "that is its start";
}

// What contact knows of the step before is not in the file.
TEST(StartState, GoesOnWithAFreeBallOnTheCloth) {
    const test::ScratchFile file("state.csv");
    Settings settings = load_scene("trampoline");
    const auto steps = static_cast<int>(std::lround(0.4 / settings.solver.dt));
    Simulation whole("trampoline", settings);
    make_steps(whole, steps);
    ASSERT_GT(whole.report().contacts, 0);
    file.write(state_text(whole));
    settings.start = file.name();
    Simulation rest("trampoline", settings);
    EXPECT_EQ(rest.hash(), whole.hash()) << "spin and turn included";
    EXPECT_EQ(rest.step_warning(), whole.step_warning());
    make_steps(whole, steps), make_steps(rest, steps);
    EXPECT_LT((rest.cloths()[0].state.x - whole.cloths()[0].state.x).rowwise().norm().maxCoeff(), 2e-3);
    EXPECT_LT((rest.balls()[0].centre - whole.balls()[0].centre).norm(), 2e-3);
    rest.apply(command::Reset{});
    EXPECT_DOUBLE_EQ(rest.report().time, 0.4);
    EXPECT_NE(rest.balls()[0].centre, settings.balls[0].position);
}

TEST(StartState, WithoutBallsIsSaidWhereThereAreSomeToMove) {
    const test::ScratchFile file("state.csv");
    const std::string header = "t,particle,x,y,z,vx,vy,vz\n", row = ",0,1,2,0,0,0\n";
    file.write(header + "3,0" + row + "3,1" + row + "3,2" + row + "3,3" + row);
    const auto warning = [&](const std::string& motion) {
        const Simulation simulation = small_simulation(
            {"cloth.particles=2,2", "pinned=none", "start=" + file.name(), "path=0,0,0,2,9,0,0,2", "motion=" + motion});
        EXPECT_EQ(simulation.report().time, 3);
        return simulation.step_warning();
    };
    EXPECT_THAT(warning("free"), HasSubstr("state.csv has no balls: they start where the scene has them"));
    EXPECT_THAT(warning("keys"), HasSubstr("has no balls"));
    EXPECT_EQ(warning("path"), "");
}

/// What is said of a state file with this text.
std::string complaint(const std::string& text) {
    const test::ScratchFile file("state.csv");
    file.write(text);
    return test::input_error_of([&] {
        small_simulation({"cloth.particles=2,2", "pinned=none", "start=" + file.name()});
    });
}

TEST(StartState, ThatIsDamagedIsRefusedWithItsLine) {
    const std::string header = "t,particle,x,y,z,vx,vy,vz\n", row = ",1,2,3,4,5,6\n";
    const std::string good = header + "0,0" + row + "0,1" + row + "0,2" + row + "0,3" + row;
    EXPECT_EQ(complaint(good), "");
    EXPECT_THAT(complaint(""), HasSubstr("state.csv:1: expected 't,particle"));
    EXPECT_THAT(complaint("x" + good), HasSubstr("state.csv:1: expected"));
    EXPECT_THAT(complaint(header), HasSubstr("ends before"));
    EXPECT_THAT(complaint(header + "0,0" + row), HasSubstr("state.csv:2: ends before the last particle"));
    EXPECT_THAT(complaint(good + "1,0" + row), HasSubstr("ends before"));
    EXPECT_THAT(complaint(good.substr(0, good.size() - 1)), HasSubstr("state.csv:5: cut off"));
    EXPECT_THAT(complaint(header + "0,1" + row), HasSubstr("state.csv:2: expected particle 0"));
    EXPECT_THAT(complaint(header + "0,0,1,2,3\n"), HasSubstr("state.csv:2: expected t,particle"));
    EXPECT_THAT(complaint(header + "0,0,1,2,3,4,5,nan\n"), HasSubstr("state.csv:2: allowed numbers"));
    EXPECT_THAT(complaint(header + "0,0,1,2,3,4,5,1e13\n"), HasSubstr("state.csv:2: allowed numbers"));
    EXPECT_THAT(complaint(header + "-1,0" + row), HasSubstr("state.csv:2: t = -1: allowed 0 <= t"));
    EXPECT_THAT(complaint(header + std::string(5000, '1') + "\n"), HasSubstr("state.csv:2: longer than"));
    EXPECT_THAT(complaint(header + "1,0" + row + "2,1" + row), HasSubstr("state.csv:3: t = 2: allowed 1, the time of"));
    const std::string later = header + "3,0" + row + "3,1" + row + "3,2" + row + "3,3" + row;
    EXPECT_EQ(complaint(later + later.substr(header.size())), "") << "the same moment twice";
    EXPECT_THAT(complaint(later + "2,0" + row), HasSubstr("state.csv:6: t = 2: allowed t >= 3"));
    EXPECT_THAT(test::input_error_of([] { small_simulation({"start=/dev/stdin"}); }), HasSubstr("allowed a regular"));
    EXPECT_THAT(test::input_error_of([] { small_simulation({"start=/no/such.csv"}); }), HasSubstr("cannot be read"));
}

TEST(StartState, WithDamagedBallsIsRefusedWithItsLine) {
    const std::string row = ",1,2,3,4,5,6\n", cloth = "0,0" + row + "0,1" + row + "0,2" + row + "0,3" + row;
    const std::string head = "t,particle,x,y,z,vx,vy,vz\n# " + std::string(ball_columns) + "\n";
    const std::string ball = ",0,0,2,0,0,0,0,0,0,0,1,0,0,0\n";
    EXPECT_EQ(complaint(head + cloth + "# 0" + ball), "");
    EXPECT_EQ(complaint(head + cloth + "# 0" + ball + cloth + "# 0" + ball), "");
    EXPECT_THAT(complaint(head), HasSubstr("state.csv:2: ends before the last particle"));
    EXPECT_THAT(complaint(head + cloth), HasSubstr("state.csv:6: ends before ball 0"));
    EXPECT_THAT(complaint(head + cloth + cloth), HasSubstr("state.csv:7: expected # t,ball,x"));
    EXPECT_THAT(complaint(head + cloth + "# 0,1,0,2,0,0,0,0,0,0,0,1,0,0,0\n"), HasSubstr("7: expected ball 0"));
    EXPECT_THAT(complaint(head + cloth + "# 1" + ball), HasSubstr("state.csv:7: t: allowed 0"));
    EXPECT_THAT(complaint(head + cloth + "# 0,0,0,2,0,0,0,0,0,0,0,2,0,0,0\n"), HasSubstr("7: turn: allowed"));
    EXPECT_THAT(complaint(head + cloth + "# 0,0,0,nan,0,0,0,0,0,0,0,1,0,0,0\n"), HasSubstr("7: allowed numbers"));
    EXPECT_THAT(complaint(head + cloth + "# 0" + ball + "# 0" + ball),
                HasSubstr("8: allowed no more balls: the scene"));
    const test::ScratchFile file("state.csv");
    file.write(head + cloth + "# 0" + ball);
    Settings without = small_simulation({"cloth.particles=2,2", "pinned=none"}).settings();
    without.balls.clear();
    without.start = file.name();
    EXPECT_THAT(test::input_error_of([&] { Simulation("drop", without); }), HasSubstr("2: allowed no balls"));
}

TEST(StartState, ThatIsBadChangesNothing) {
    Simulation simulation = small_simulation();
    make_steps(simulation, 10);
    const std::uint64_t hash = simulation.hash();
    EXPECT_THROW(simulation.apply(command::Set{"start=/no/such.csv"}), InputError);
    EXPECT_EQ(simulation.hash(), hash);
    EXPECT_EQ(simulation.settings().start, "");
}

void expect_same(const Settings& a, const Settings& b, const std::string& name) {
    for (const Setting& setting : setting_table()) {
        ASSERT_EQ(section_count(a, setting), section_count(b, setting)) << name << ": " << setting.full_name();
        for (std::size_t i = 0; i < section_count(a, setting); ++i) {
            EXPECT_EQ(setting.read(a, i), setting.read(b, i)) << name << ": " << setting.full_name();
        }
    }
}

TEST(SceneText, IsReadBackAsTheSameSettings) {
    for (const std::string& name : scene_names()) {
        const Settings settings = load_scene(name);
        expect_same(parse_scene(scene_text(settings), scene_file(name).string()), settings, name);
    }
    Settings odd = small_settings();
    odd.title = R"(quotes " and \ backslashes)";
    odd.cloths.push_back(odd.cloths[0]);
    odd.cloths[1].centred = true;
    odd.cloths[1].pinned = {Pins::Kind::List, {}};
    for (int p = 0; p < 80; ++p) odd.cloths[1].pinned.list.push_back(p);
    odd.balls.push_back(odd.balls[0]);
    odd.balls[1].motion = BallMotion::Path;
    odd.balls[1].path = {{0, Vec3(1, 2, 3)}, {Real(0.1), Vec3(4, 5, Real(1) / 3)}};
    SolidSettings& capsule = odd.solids.emplace_back();
    capsule.shape = SolidKind::Capsule;
    capsule.axis = {0, 0, 1};
    capsule.angle = 30;
    odd.solver.dt = 1.0 / 3000;
    odd.view.eye = Vec3(1, 2, 3);
    expect_same(parse_scene(scene_text(odd), "odd.toml"), odd, "odd");
}

}  // namespace
}  // namespace drape
