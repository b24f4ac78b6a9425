// The window's picture, and that of drape-capture --overlay: the same.

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "app/window_fixture.h"
#include "drape/base/numbers.h"
#include "drape/render/image.h"
#include "drape/scene/scene.h"
#include "support/read_png.h"

namespace drape {
namespace {

using test::eventually;
using test::Process;
using test::program;

// Pixels in which two pictures differ by more than drivers may: 8 of 255 in one of the colours
class PictureDifference {
public:
    PictureDifference(const Image& one, const Image& other) {
        EXPECT_EQ(one.width, other.width);
        EXPECT_EQ(one.height, other.height);
        for (int y = 0; y < one.height; ++y) {
            for (int x = 0; x < one.width; ++x) {
                int most = 0;
                for (int c = 0; c < 3; ++c) most = std::max(most, std::abs(one.pixel(x, y)[c] - other.pixel(x, y)[c]));
                if (most > 8) add(x, y);
            }
        }
    }

    /// Whether rows of the panel that depend on the machine are all: FPS, and two below what a search takes. A few
    /// pixels at edges may differ.
    [[nodiscard]] bool is_only_speed() const {
        constexpr int most_outside = 30, rows_width = 205, rows_height = 42;
        return outside_ <= most_outside && right_ - left_ <= rows_width && bottom_ - top_ <= rows_height;
    }

    [[nodiscard]] std::string text() const {
        return std::to_string(outside_) + " pixels beside the panel; in it from " + std::to_string(left_) + ", " +
               std::to_string(top_) + " to " + std::to_string(right_) + ", " + std::to_string(bottom_);
    }

private:
    void add(int x, int y) {
        constexpr int panel_right = 215, panel_bottom = 200;  // at 640 x 480, from the upper left
        if (x >= panel_right || y >= panel_bottom) {
            ++outside_;
            return;
        }
        const bool is_first = right_ == 0;
        left_ = is_first ? x : std::min(left_, x), top_ = is_first ? y : std::min(top_, y);
        right_ = std::max(right_, x), bottom_ = std::max(bottom_, y);
    }

    int outside_ = 0, left_ = 0, top_ = 0, right_ = 0, bottom_ = 0;
};

class WindowPicture : public test::WindowTest {
protected:
    // A recording that makes some steps of a scene and stays there; a window that is slow would say so in its picture
    [[nodiscard]] std::string recording_of(const std::string& scene, int steps, const std::string& set = {}) const {
        const std::string name = file(scene + "-" + std::to_string(steps) + ".txt");
        std::ofstream(name) << "drape-recording 1\nscene " << scene << "\n0 set view.quality=full\n"
                            << (set.empty() ? "" : "0 set " + set + "\n") << "0 pause\n0 step " << steps << "\n"
                            << steps << " end\n";
        return name;
    }

    // The picture of F12 after these steps
    Image picture_of_window(const std::string& recorded_run, int steps) {
        start({"--replay", recorded_run});
        wait_for_step(steps);
        Image picture = screenshot();
        quit();
        return picture;
    }

    void wait_for_step(int steps) {
        // A key that changes nothing when it is pressed twice is recorded with the number of the step. One that is
        // pressed before the window has the keyboard goes nowhere
        const auto toggles = [this] {
            const std::vector<std::string> all = commands();
            return std::ranges::count(all, "next view.wireframe");
        };
        EXPECT_TRUE(eventually([&] {
            const auto before = toggles();
            desktop_.key("l");
            eventually([&] { return toggles() > before; }, 5);
            return toggles() % 2 == 0 && last_step() >= steps;
        }));
    }

    Image screenshot() {
        std::filesystem::remove(file("drape-0001.png"));
        desktop_.key("F12");
        EXPECT_TRUE(eventually([&] { return std::filesystem::exists(file("drape-0001.png")); }));
        return read_png(file("drape-0001.png"));
    }

    // One frame at the time of these steps
    Image picture_of_capture(const std::string& recorded_run, double time, const std::vector<std::string>& more) {
        std::vector<std::string> words{program("drape-capture"), "--replay", recorded_run, "--frames", "1", "--again"};
        words.insert(words.end(), {"--fps", real_text(1 / time), "--size", "640x480", "--out", file("frames")});
        words.insert(words.end(), more.begin(), more.end());
        Process capture(words, {}, folder_);
        EXPECT_EQ(capture.wait(120), 0) << capture.standard_error();
        return read_png(file("frames/frame_0001.png"));
    }

    // Between two steps, so that rounding does not count
    static double time_of(const std::string& scene, int steps) { return (steps + 0.5) * load_scene(scene).solver.dt; }

    void expect_that_of_drape_capture(const std::string& scene) {
        const int steps = scene.starts_with("fails_") ? 5 : static_cast<int>(0.2 / load_scene(scene).solver.dt);
        const std::string recorded_run = recording_of(scene, steps);
        const PictureDifference found(picture_of_window(recorded_run, steps),
                                      picture_of_capture(recorded_run, time_of(scene, steps), {"--overlay"}));
        EXPECT_TRUE(found.is_only_speed()) << scene << ": " << found.text();
    }
};

TEST_F(WindowPicture, IsThatOfDrapeCaptureAndToldFromOthers) {
    const std::string recorded_run = recording_of("drop", 60, "view.particles=true");
    const Image window = picture_of_window(recorded_run, 60);
    const auto difference = [&](const std::string& other_run, int steps, const std::vector<std::string>& more) {
        return PictureDifference(window, picture_of_capture(other_run, time_of("drop", steps), more));
    };
    const PictureDifference same = difference(recorded_run, 60, {"--overlay"});
    EXPECT_TRUE(same.is_only_speed()) << same.text();
    EXPECT_FALSE(difference(recorded_run, 60, {}).is_only_speed()) << "without the panel";
    const PictureDifference moved = difference(recording_of("drop", 400, "view.particles=true"), 400, {"--overlay"});
    EXPECT_FALSE(moved.is_only_speed()) << "another moment: " << moved.text();
}

using NightlyWindowPicture = WindowPicture;

TEST_F(NightlyWindowPicture, IsThatOfDrapeCaptureInEveryScene) {
    for (const std::string& scene : scene_names()) expect_that_of_drape_capture(scene);
}

}  // namespace
}  // namespace drape
