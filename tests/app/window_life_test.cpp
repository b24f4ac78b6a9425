// How the window lives and ends, and what is left of it.

#include <csignal>
#include <fstream>
#include <set>

#include "app/window_fixture.h"
#include "drape/base/numbers.h"
#include "drape/base/stopwatch.h"
#include "drape/render/image.h"
#include "drape/scene/scene.h"
#include "drape/session/tour.h"
#include "support/read_png.h"

namespace drape {
namespace {

using test::eventually;
using test::Process;
using test::program;
using test::read_file;
using test::WindowTest;

bool closed(const std::string& recording) { return recording.ends_with(" end\n"); }

TEST_F(WindowTest, SignalsAndTheWindowManagerEndIt) {
    for (const int signal : {SIGTERM, 0}) {
        // The threads of the solver are there before the window is
        start({"hang", "--set", "solver.threads=2"});
        if (signal == SIGTERM) desktop_.open_menu(100, 100);
        signal == 0 ? desktop_.ask_to_close(window_) : drape_->send(signal);
        EXPECT_EQ(drape_->wait(60), signal == 0 ? 0 : 128 + signal) << drape_->standard_error();
        EXPECT_TRUE(closed(read_file(file("session.txt"))));
    }
}

TEST_F(WindowTest, ARunThatDivergesClosesItsRecording) {
    Process lost({program("drape"), "fails_explicit_euler", "--record", "session.txt", "--set", "on_unstable=stop",
                  "view.speed=1", "--size", "640x480"},
                 {{"DISPLAY", desktop_.display()}}, folder_);
    EXPECT_EQ(lost.wait(60), 1) << lost.standard_error();
    EXPECT_TRUE(closed(read_file(file("session.txt"))));
}

TEST_F(WindowTest, AfterADivergenceShiftRStartsAgainWithAStepThatHolds) {
    start({"fails_rk4", "--set", "view.speed=1"});
    const auto failures = [this] {
        const std::string said = drape_->standard_error();
        int count = 0;
        for (std::size_t at = 0; (at = said.find("Diverged after step", at)) != std::string::npos; ++at) ++count;
        return count;
    };
    ASSERT_TRUE(eventually([&] { return failures() == 1; }));
    desktop_.key("shift+r");
    EXPECT_TRUE(recorded("set solver.dt=9.25e-05")) << "0.9 of the limit";
    EXPECT_TRUE(recorded("reset"));
    constexpr int far_beyond_the_failure = 2000;  // which comes at step 241
    EXPECT_TRUE(eventually([&] {
        desktop_.key("l");
        return last_step() > far_beyond_the_failure;
    }));
    EXPECT_EQ(failures(), 1);
    quit();
}

TEST_F(WindowTest, ItsRecordingIsNoFileThatItReads) {
    std::ofstream(file("r.txt")) << "drape-recording 1\nscene hang\n9 end\n";
    std::filesystem::create_symlink("r.txt", file("link.txt"));
    for (const char* name : {"r.txt", "./r.txt", "link.txt"}) {
        Process wrong({program("drape"), "--record", name, "--replay", "r.txt"}, {{"DISPLAY", desktop_.display()}},
                      folder_);
        EXPECT_EQ(wrong.wait(60), 2);
        EXPECT_NE(wrong.standard_error().find("--replay "), std::string::npos) << wrong.standard_error();
    }
    EXPECT_EQ(read_file(file("r.txt")), "drape-recording 1\nscene hang\n9 end\n");
}

TEST_F(WindowTest, TheRecordingOfAKilledOneIsKept) {
    start({"hang"});
    desktop_.key("v");
    ASSERT_TRUE(recorded("next wind.on"));
    drape_->send(SIGKILL);
    drape_->wait(60);
    start({"hang"});
    quit();
    EXPECT_NE(drape_->standard_error().find("session.txt-1.unfinished"), std::string::npos);
    EXPECT_NE(read_file(file("session.txt-1.unfinished")).find("next wind.on"), std::string::npos);
    EXPECT_EQ(read_file(file("session.txt")).find("next wind.on"), std::string::npos);
    EXPECT_TRUE(closed(read_file(file("session.txt"))));
}

TEST_F(WindowTest, OnePixelAndHidingDoNoHarmAndPicturesDoNotOverwriteOneAnother) {
    start({"hang", "--set", "view.bounds=true"});
    desktop_.act({"windowsize", "--sync", window_, "1", "1"});
    desktop_.key("v");
    EXPECT_TRUE(recorded("next wind.on"));
    desktop_.act({"windowsize", "--sync", window_, "640", "480"});
    desktop_.key("F12");
    ASSERT_TRUE(eventually([&] { return std::filesystem::exists(file("drape-0001.png")); }));
    const std::string first = read_file(file("drape-0001.png"));
    EXPECT_NE(first.find("iTXtCommit"), std::string::npos);

    desktop_.act({"windowunmap", "--sync", window_});
    const double before = drape_->processor_time();
    EXPECT_TRUE(eventually([&] { return drape_->processor_time() > before + 0.05; }));
    EXPECT_TRUE(drape_->running());
    desktop_.act({"windowmap", "--sync", window_});
    desktop_.act({"windowfocus", window_});
    desktop_.key("F12");
    EXPECT_TRUE(eventually([&] { return std::filesystem::exists(file("drape-0002.png")); }));
    EXPECT_EQ(read_file(file("drape-0001.png")), first);
    quit();
}

// What a program does while its first thread goes to sleep some times.
struct Turns {
    double processor;  // s
    double time;       // s
};

constexpr int turns_watched = 60;

Turns watch_turns(const Process& process) {
    const Stopwatch watch;
    const long long sleeps = process.sleeps();
    const double before = process.processor_time();
    EXPECT_TRUE(eventually([&] { return process.sleeps() >= sleeps + turns_watched; })) << "it never sleeps";
    return {process.processor_time() - before, watch.seconds()};
}

// With pictures of one kind that are never drawn again in another, too
class PausedWindow : public WindowTest, public testing::WithParamInterface<std::string> {};
INSTANTIATE_TEST_SUITE_P(Qualities, PausedWindow, testing::Values("auto", "fast"),
                         [](const auto& quality) { return quality.param; });

TEST_P(PausedWindow, Rests) {
    start({"hang", "--set", "solver.sleep_speed=0", "view.bounds=true", "view.quality=" + GetParam()});
    desktop_.key("v");
    ASSERT_TRUE(recorded("next wind.on"));
    const Turns running = watch_turns(*drape_);
    desktop_.key("p");
    ASSERT_TRUE(recorded("pause"));
    // It may draw a little longer. Both figures are as good on a busy machine: one counts no waiting, the other is a
    // least time.
    constexpr int most_watches = 10;
    constexpr double most_turns = 200;  // in a second
    Turns paused{};
    bool rests = false;
    for (int watch = 0; watch < most_watches && !rests && !HasFailure(); ++watch) {
        paused = watch_turns(*drape_);
        rests = paused.processor < running.processor / 4 && paused.time > turns_watched / most_turns;
    }
    EXPECT_TRUE(rests) << turns_watched << " turns take " << paused.processor << " s of processor time in "
                       << paused.time << " s, and " << running.processor << " s while it runs";
    quit();
}

// What a program says when it replays a recording.
std::string replay(std::vector<std::string> words, const std::string& recording) {
    words.insert(words.end(), {"--replay", recording});
    const std::filesystem::path folder = std::filesystem::path(recording).parent_path();
    Process other(words, {{"DISPLAY", ""}}, folder);
    const auto status = other.wait(300);
    return (status == 0 ? "" : "differs: ended badly\n") + other.standard_error() + other.standard_output();
}

TEST_F(WindowTest, SavesAtItsEndWhatAnotherGoesOnFrom) {
    start({"trampoline", "--save", file("first.snapshot")});
    desktop_.key("v");
    ASSERT_TRUE(recorded("next "));
    quit();
    start({"--load", file("first.snapshot"), "--save", file("second.snapshot")});
    const std::string hash = quit();
    EXPECT_NE(read_file(file("session.txt")).find("scene trampoline\n0 load "), std::string::npos);
    Process capture(
        {program("drape-capture"), "--load", file("second.snapshot"), "--frames", "1", "--fps", "1e5", "--hash"},
        {{"DISPLAY", ""}}, file("."));
    EXPECT_EQ(capture.wait(300), 0) << capture.standard_error();
    EXPECT_EQ(capture.standard_output(), hash) << "the same state";
}

TEST_F(WindowTest, ItsRecordingGivesTheSameBitsWithoutAWindow) {
    start({"original", "--set", "solver.integrator=velocity_verlet"});
    desktop_.act({"keydown", "Up"});
    ASSERT_TRUE(recorded("steer "));
    const long long steered = last_step();
    ASSERT_TRUE(eventually([&] { return last_step() > steered; })) << "no hash of a later step";
    desktop_.act({"keyup", "Up"});
    desktop_.key("v");
    // Not far: cloth that is drawn out by the hand has a shorter stability limit
    desktop_.drag({}, 1, {320, 200}, {328, 205});
    desktop_.key("p");
    ASSERT_TRUE(recorded("pause"));
    ASSERT_TRUE(recorded_now("drag "));
    const std::string hash = quit();
    ASSERT_EQ(hash.size(), 17u);
    const double end = static_cast<double>(last_step()) * load_scene("original").solver.dt;

    // The closing hash stands in the recording, and both programs compare it with their own.
    const std::string recording = read_file(file("session.txt"));
    const std::string closing = " hash " + hash.substr(0, 16);
    const std::size_t place = recording.rfind(closing);
    ASSERT_NE(place, std::string::npos);
    std::string forged = recording;
    forged.replace(place, closing.size(), " hash 0123456789abcdef");
    std::ofstream(file("forged.txt")) << forged;

    const std::vector<std::vector<std::string>> programs{
        {program("drape-lab"), "simulate"},
        {program("drape-capture"), "--frames", "1", "--fps", real_text(1 / (end + 0.05)), "--size", "64x64", "--out",
         file("frames"), "--again"}};
    for (const std::vector<std::string>& words : programs) {
        const std::string same = replay(words, file("session.txt"));
        EXPECT_EQ(same.find("differs"), std::string::npos) << words.front() << ": " << same;
        EXPECT_NE(replay(words, file("forged.txt")).find("differs"), std::string::npos) << words.front();
    }
}

TEST_F(WindowTest, WithoutADisplayItDrawsOffScreen) {
    for (const char* time : {"the first time", "and again"}) {
        Process blind({program("drape"), "hang", "--set", "solver.dt=4e-4", "--size", "64x48"}, {{"DISPLAY", ""}},
                      folder_);
        EXPECT_EQ(blind.wait(300), 0) << time;
        const std::string said = blind.standard_error();
        EXPECT_TRUE(said.ends_with("120 pictures in " + file("drape-frames") + "\n")) << said;
    }
    int pictures = 0;
    for (const auto& entry : std::filesystem::directory_iterator(file("drape-frames"))) {
        pictures += entry.path().extension() == ".png" ? 1 : 0;
    }
    EXPECT_EQ(pictures, 120);
}

TEST_F(WindowTest, WithoutADisplayTheTourIsDrawnOffScreen) {
    Process blind({program("drape"), "--tour", "--size", "64x48", "--scale", "2"}, {{"DISPLAY", ""}}, folder_);
    EXPECT_EQ(blind.wait(300), 0) << blind.standard_error();
    EXPECT_TRUE(blind.standard_error().ends_with("13 pictures in " + file("drape-frames") + "\n"))
        << blind.standard_error();
    const std::string first = read_file(file("drape-frames/frame_0001.png"));
    EXPECT_NE(first.find("iTXtScene" + std::string(5, '\0') + std::string(tour_stops().front().scene)),
              std::string::npos);
    std::set<std::vector<std::uint8_t>> pictures;
    for (const auto& picture : std::filesystem::directory_iterator(file("drape-frames"))) {
        pictures.insert(read_png(picture.path()).rgb);
    }
    EXPECT_EQ(pictures.size(), tour_stops().size()) << "each is another";
}

TEST_F(WindowTest, HasTheSizeOfTheLastTimeUnlessItIsTold) {
    const auto size_now = [this] {
        const std::string said = desktop_.act({"getwindowgeometry", "--shell", window_});
        return said.substr(said.find("WIDTH="), said.find("\nSCREEN") - said.find("WIDTH="));
    };
    const auto size_of_window = [&, this](const std::vector<std::string>& options) {
        std::vector<std::string> words{program("drape"), "hang"};
        words.insert(words.end(), options.begin(), options.end());
        drape_.emplace(
            words, std::map<std::string, std::string>{{"DISPLAY", desktop_.display()}, {"XDG_STATE_HOME", file("")}},
            folder_);
        window_ = desktop_.find_window();
        return size_now();
    };
    const auto resize_and_quit = [this](const std::string& width, const std::string& height) {
        desktop_.act({"windowsize", "--sync", window_, width, height});
        quit();
    };
    for (const char* told : {"--check", "--size=640x480"}) {
        size_of_window({told});
        resize_and_quit("900", "500");
        EXPECT_FALSE(std::filesystem::exists(file("drape"))) << told;
    }
    desktop_.set_resources("Xft.dpi: 72");
    EXPECT_EQ(size_of_window({}), "WIDTH=1280\nHEIGHT=720");
    resize_and_quit("900", "500");
    EXPECT_EQ(size_of_window({}), "WIDTH=900\nHEIGHT=500");
    const auto becomes = [&](const char* size) { return eventually([&] { return size_now() == size; }); };
    desktop_.key("F11");
    EXPECT_TRUE(becomes("WIDTH=1280\nHEIGHT=1024")) << size_now();
    desktop_.key("F11");
    EXPECT_TRUE(becomes("WIDTH=900\nHEIGHT=500")) << size_now();
    desktop_.key("F11");
    EXPECT_TRUE(becomes("WIDTH=1280\nHEIGHT=1024")) << size_now();
    quit();
    EXPECT_EQ(size_of_window({}), "WIDTH=900\nHEIGHT=500") << "not that of the screen";
    quit();
    EXPECT_EQ(size_of_window({"--check"}), "WIDTH=1280\nHEIGHT=720");
    quit();
    std::filesystem::remove_all(file("drape"));
    desktop_.set_resources("Xft.dpi: 120");
    EXPECT_EQ(size_of_window({}), "WIDTH=1280\nHEIGHT=900") << "as wide as the screen, and 1.25 times as high";
    quit();
}

TEST_F(WindowTest, CheckedInEveryFrameItEndsWell) {
    start({"drop", "--check"});
    desktop_.click(4);
    EXPECT_TRUE(recorded("zoom"));
    quit();
}

TEST_F(WindowTest, ASceneThatIsSavedBeginsAgain) {
    const auto save = [this](const std::string& text) { std::ofstream(file("mine.toml")) << text; };
    const auto is_titled = [this](const std::string& title) {
        return eventually([&] { return desktop_.act({"getwindowname", window_}) == "Drape - " + title; });
    };
    save("title = 'first'\n[cloth]\n");
    start({"mine.toml"});
    EXPECT_TRUE(is_titled("first"));
    save("title = 'second one'\n[cloth]\n");
    EXPECT_TRUE(is_titled("second one"));
    EXPECT_TRUE(recorded("scene mine.toml"));
    const std::size_t so_far = commands().size();
    const long long step = last_step();
    save("title = 'third'\n[cloth]\nparticles = [1, 2]\n");
    ASSERT_TRUE(eventually([this] { return drape_->standard_error().find("mine.toml:3:") != std::string::npos; }));
    EXPECT_TRUE(eventually([&] { return last_step() > step; })) << "the scene as it was goes on";
    EXPECT_FALSE(recorded_now("scene", so_far));
    save("title = 'the fourth'\n[cloth]\n");
    EXPECT_TRUE(is_titled("the fourth"));
    quit();
}

TEST_F(WindowTest, AShotIsShownOnceMoreSlowly) {
    start({"bullet", "--set", "view.repeat=0.05"});
    EXPECT_TRUE(recorded("set view.speed=1"));
    EXPECT_EQ(commands(), (std::vector<std::string>{"set view.speed=0.1", "reset", "set view.speed=1"}));
    desktop_.key("r");
    EXPECT_TRUE(recorded("set view.speed=0.1", 3));
    desktop_.key("x");
    EXPECT_TRUE(recorded("set view.speed=1", 5)) << "what the user does has its own time";
    const std::size_t so_far = commands().size();
    desktop_.act({"key", "--repeat", "7", "F1"});
    EXPECT_TRUE(recorded("reset", so_far)) << "the stop of the tour on tunnelling";
    quit();
}

TEST_F(WindowTest, BadInputIsToldBeforeAnythingOpens) {
    for (const std::string& display : {std::string(), desktop_.display()}) {
        Process wrong({program("drape"), "hang", "--set", "solver.dt=nan"}, {{"DISPLAY", display}}, folder_);
        EXPECT_EQ(wrong.wait(60), 2);
        EXPECT_NE(wrong.standard_error().find("dt"), std::string::npos) << wrong.standard_error();
        EXPECT_EQ(wrong.standard_error().find("drape-frames"), std::string::npos);

        Process compared({program("drape"), "hang", "--versus", "solver.dt=nan"}, {{"DISPLAY", display}}, folder_);
        EXPECT_EQ(compared.wait(60), 2) << "on display '" << display << "'";
        EXPECT_NE(compared.standard_error().find("--versus: solver.dt"), std::string::npos);
    }
}

}  // namespace
}  // namespace drape
