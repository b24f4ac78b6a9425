// What the panels say of a run, read from what they draw.

#include <gmock/gmock.h>

#include <optional>
#include <set>

#include "drape/render/entries.h"
#include "drape/scene/scene.h"
#include "drape/session/comparison.h"
#include "drape/sim/simulation.h"
#include "drawn_text.h"
#include "render/overlay_panels.h"

namespace drape {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

/// The first scene, in which cloth lies on a ball and on cloth.
class PanelText : public testing::Test {
protected:
    PanelText() {
        while (simulation_.report().contacts == 0) simulation_.step();
        settings_ = simulation_.settings();
        report_ = simulation_.report();
        report_.times = {.step = 1e-5, .build = 2e-5, .pairs = 3e-5};
        panels_.settings.set_scene(settings_);
    }

    std::string text(int width = 1280, int height = 720) {
        FrameView view = simulation_.view();
        view.settings = &settings_;
        view.report = &report_;
        view.paused = paused_;
        view.timeline = timeline_;
        view.search = search_ ? &*search_ : nullptr;
        view.comparison = compared_ ? &*compared_ : nullptr;
        for (int frame = 0; frame < 2; ++frame) panels_.build(view, Camera(settings_.view), {}, {}, width, height);
        return test::drawn_text();
    }

    Simulation simulation_{"veil", load_scene("veil")};
    Settings settings_;
    StepReport report_;
    std::optional<SearchTimes> search_;
    std::optional<ComparisonView> compared_;
    bool paused_ = false;
    Timeline timeline_;
    OverlayPanels panels_;
};

TEST_F(PanelText, SaysInOneLineWhetherTheTreeSavesTestsAndTime) {
    EXPECT_THAT(text(), ContainsRegex("tests saved [0-9]+ %; B shows how"));
    settings_.view.bounds = true;
    EXPECT_THAT(text(), ContainsRegex("tests saved [0-9]+ % of 1 521"));
    settings_.view.panel = PanelSize::Full;
    search_ = {.hierarchy = 26e-6, .brute_force = 11e-6, .tests = 101, .tests_of_brute_force = 2000};
    EXPECT_THAT(text(), AllOf(HasSubstr("tests saved 94 %, but no time"), HasSubstr("tests, in all 101 of 2 000"),
                              HasSubstr("search, in all 26.0 us"), HasSubstr("by brute force 11.0 us\n"),
                              HasSubstr("to save time U: update")));
    search_->brute_force = 52e-6;
    EXPECT_THAT(text(), AllOf(HasSubstr("tests saved 94 %, 2.0x as fast\n"), Not(HasSubstr("to save time"))));
    EXPECT_THAT(text(), HasSubstr("in all: 101 tests, by brute force 2000; 2.0x as fast")) << "B";
    settings_.view = {.panel = PanelSize::Compact};
    EXPECT_THAT(text(), HasSubstr("tests saved 94 %, 2.0x as fast (B)"));
    search_->brute_force = 4.4e-3;
    EXPECT_THAT(text(), HasSubstr("tests saved 94 %, 169x as fast (B)"));
    settings_.view.panel = PanelSize::Full;
    search_->hierarchy = 999.94e-6, search_->brute_force = 999.96e-6;
    EXPECT_THAT(text(), AllOf(HasSubstr("in all 999.9 us"), HasSubstr("by brute force 1.00 ms"))) << "as best read";
}

TEST_F(PanelText, HasNoTimesOfWhatASleepingSceneDoesNotDo) {
    settings_.view.panel = PanelSize::Full;
    settings_.view.bounds = true;
    EXPECT_THAT(text(), AllOf(HasSubstr("build 20.0 us"), HasSubstr("cloth on cloth 30.0 us"), HasSubstr("FPS"),
                              HasSubstr("build of all levels: 20 us")));
    report_.step = 1;
    report_.times = {};
    report_.asleep = true;
    EXPECT_THAT(text(), AllOf(HasSubstr("state asleep"), Not(HasSubstr(" 0.0 us")), Not(HasSubstr("FPS")),
                              Not(HasSubstr("build of all levels"))));
}

TEST_F(PanelText, HasTheWholeBalanceWithoutASignOfZeroBeforeLesserRows) {
    settings_.solver.ledger = true;
    report_.balance = {};
    report_.balance.contact = -1e-7;
    report_.balance.drag = 0.25;
    EXPECT_THAT(text(), AllOf(HasSubstr("to contact 0.0000 J"), HasSubstr("to drag 0.2500 J")));
    settings_.view.panel = PanelSize::Full;
    settings_.view.plots = true;
    EXPECT_THAT(text(), AllOf(HasSubstr("to drag 0.2500 J"), ContainsRegex("no room for [0-9]+ more")));
    EXPECT_THAT(text(1280, 1400), Not(HasSubstr("no room for")));
}

TEST_F(PanelText, SaysWhatTheRowUnderThePointerMeans) {
    settings_.view.panel = PanelSize::Full;
    settings_.solver.ledger = true;
    panels_.hover_x = 40;
    std::set<std::string> meanings;
    const std::string usual = text();
    for (panels_.hover_y = 0; panels_.hover_y < 720; panels_.hover_y += 4) {
        const std::string with_meaning = text();
        if (with_meaning.starts_with(usual)) meanings.insert(with_meaning.substr(usual.size()));
    }
    EXPECT_GE(meanings.size(), 20u);
    EXPECT_THAT(meanings, Contains(HasSubstr("What the run does now")));
    EXPECT_THAT(meanings, Contains(HasSubstr("The part of all tests")));
}

TEST_F(PanelText, SaysWhetherWhatWasBeforeIsReplayed) {
    EXPECT_THAT(text(), HasSubstr("state running"));
    timeline_ = {.now = 3, .newest = 7};
    EXPECT_THAT(text(), HasSubstr("state replaying"));
    paused_ = true;
    EXPECT_THAT(text(), HasSubstr("state paused"));
}

TEST_F(PanelText, HasEveryAssignmentOfAComparison) {
    Comparison comparison(Simulation("veil", load_scene("veil")),
                          "solver.integrator=backward_euler,solver.dt=1e-3,contact.volume=kdop18");
    compared_ = comparison.view(simulation_);
    EXPECT_THAT(text(), HasSubstr("solver.integrator=backward_euler\nsolver.dt=1e-3\ncontact.volume=kdop18\n"));
}

TEST_F(PanelText, OfAComparisonHasNoTimeOfARunThatSleeps) {
    Comparison comparison(simulation_, "cloth.particles=20,20");
    compared_ = comparison.view(simulation_);
    EXPECT_THAT(text(), Not(HasSubstr("asleep")));
    StepReport other = *compared_->other.report;
    other.asleep = true;
    compared_->other.report = &other;
    EXPECT_THAT(text(),
                ContainsRegex("step \\[us\\] [0-9]+ asleep\nBVH \\[us\\] [0-9.]+ asleep\nvolume tests [0-9]+ 0"));
}

TEST_F(PanelText, SaysInPlaceOfTheTimelineThatASceneIsTooLargeToGoBackIn) {
    const auto says_it = [&](bool paused, Timeline timeline) {
        paused_ = paused;
        timeline_ = timeline;
        return text().find("This scene is too large to go back in") != std::string::npos;
    };
    EXPECT_TRUE(says_it(true, {.oldest = 7, .now = 7, .newest = 7}));
    EXPECT_FALSE(says_it(false, {.oldest = 7, .now = 7, .newest = 7}));
    EXPECT_FALSE(says_it(true, {.oldest = 7, .now = 7, .newest = 7, .bytes = 1e6})) << "the past begins here";
    EXPECT_FALSE(says_it(true, {})) << "a picture of drape-capture";
}

TEST_F(PanelText, NamesTheLimitAndTheRangeOfAPlot) {
    settings_.view.plots = true;
    EXPECT_THAT(text(), HasSubstr("dt / limit limit\n"));
    EXPECT_THAT(text(), ContainsRegex("-10 s now 0 to 1.05"));
}

TEST_F(PanelText, OfASettingsNumberLeavesItsUnitOutWhereTheGrabWouldBeUnderIt) {
    settings_.view.controls = true;
    panels_.settings.show(find_setting("cloth.drag"));
    EXPECT_THAT(text(), AllOf(HasSubstr("0.00045 drag"), HasSubstr("0.015 N s/m structural damping")));
}

TEST_F(PanelText, OfTheMenuFindsAKeyByItsSignAndNamesIt) {
    const std::vector<Entry> entries = make_entries(scene_names());
    for (const char* key : {",", ".", "-", "=", "+"}) {
        panels_.open_menu(entries, settings_);
        panels_.type(static_cast<unsigned char>(*key));
        EXPECT_THAT(text(), HasSubstr(key_name(key)));
        panels_.type('\r');
        EXPECT_EQ(panels_.wishes.entry, find_entry(entries, key) - entries.data()) << key;
    }
}

}  // namespace
}  // namespace drape
