// Pictures of all scenes, looks, panels and stops of the tour are those of golden_pictures.txt, which has the mean
// colours of 16 x 9 blocks of each. Where they are to change, look at them first (`drape-capture SCENE`, `--tour`);
// then
//   DRAPE_GOLDEN=$PWD/tests/capture/golden_pictures.txt build/test/bin/test_capture --gtest_filter=*Golden*AllSizes
// writes the table. Finer faults are those of picture_test.cpp.

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <fstream>
#include <map>
#include <span>

#include "drape/render/entries.h"
#include "drape/session/session.h"
#include "drape/session/tour.h"
#include "drawn_scene.h"

namespace drape::test {
namespace {

constexpr int blocks_across = 16, blocks_down = 9;
constexpr PictureSize sizes[] = {{640, 360}, {1280, 720}, {1920, 1080}};

/// Mean red, green and blue of each block, 4 of 255 a letter from '0' on.
std::string blocks_of(const Image& image) {
    std::string blocks;
    for (int block = 0; block < blocks_across * blocks_down; ++block) {
        const int wide = image.width / blocks_across, high = image.height / blocks_down;
        std::array<long, 3> sum{};
        for (int pixel = 0; pixel < wide * high; ++pixel) {
            const int x = block % blocks_across * wide + pixel % wide, y = block / blocks_across * high + pixel / wide;
            for (std::size_t c = 0; c < sum.size(); ++c) sum[c] += image.pixel(x, y)[c];
        }
        for (const long colour : sum) blocks += static_cast<char>('0' + colour / (4L * wide * high));
    }
    return blocks;
}

/// What is wrong with a picture; empty: nothing. Drivers may differ, and so may the times that a panel shows.
std::string difference(const std::string& blocks, const std::string& golden) {
    constexpr int most = 2;  // letters
    if (golden.size() != blocks.size()) return "is not in the table";
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        if (std::abs(blocks[i] - golden[i]) <= most) continue;
        const auto block = static_cast<int>(i / 3);
        return "column " + std::to_string(block % blocks_across) + ", row " + std::to_string(block / blocks_across) +
               ": " + std::to_string(4 * (blocks[i] - golden[i])) + " of 255 in colour " + std::to_string(i % 3);
    }
    return "";
}

/// What leads to a picture. Without panels, whose size goes in steps, it looks alike at all sizes.
struct Shown {
    std::string name;
    std::vector<Command> commands;
    double time;  // s
    bool has_panels = true;
    std::vector<KeyHelp> hint = {};
};

std::vector<Shown> all_scenes() {
    std::vector<Shown> all;
    const command::Set no_panel{"view.panel=off"};
    for (const std::string& scene : scene_names()) {
        all.push_back({scene, {command::LoadScene{scene}, no_panel}, 0.2, false});
    }
    for (const std::string look :
         {"palette=dusk", "palette=linen", "fabric=silk", "fabric=denim", "grid=false", "quality=fast"}) {
        all.push_back({look, {command::LoadScene{"drop"}, no_panel, command::Set{"view." + look}}, 0.3, false});
    }
    return all;
}

std::vector<Shown> all_panels() {
    std::vector<Shown> all;
    for (const std::string panel : {"panel=full", "plots=true", "bounds=true", "contacts=true", "colour=strain",
                                    "colour=principal_strain", "controls=true", "help=true", "particles=true"}) {
        all.push_back({panel, {command::LoadScene{"drop"}, command::Set{"view." + panel}}, 0.3});
    }
    return all;
}

std::vector<Shown> all_stops() {
    std::vector<Shown> all;
    for (const TourStop& stop : tour_stops()) {
        const std::string name = "stop" + std::to_string(all.size() + 1);
        all.push_back({name, commands_of(stop), stop.time, true, tour_hint(all.size())});
    }
    return all;
}

class Golden : public testing::Test {
protected:
    Golden() {
        std::ifstream table(std::string(DRAPE_SOURCE_DIR) + "/tests/capture/golden_pictures.txt");
        for (std::string name, blocks; !new_table_ && table >> name >> blocks;) golden_[name] = blocks;
        renderer_.panels().help = help_lines(make_entries(scene_names()), true);
    }

    /// Draws at each size, and compares; or where it is asked for, writes the table.
    void expect_golden(const std::vector<Shown>& pictures, std::span<const PictureSize> wanted) {
        for (const Shown& shown : pictures) {
            Session session(Simulation("hang", load_scene("hang")));
            for (const Command& command : shown.commands) session.send(command);
            renderer_.panels().set_scene(session.simulation().settings());
            renderer_.panels().hint = shown.hint;
            const auto draw = [&](const PictureSize& size) {
                renderer_.resize(size.width, size.height);
                renderer_.draw(session.view(), Camera(session.simulation().settings().view), {});
            };
            // Panels show medians and curves of what was drawn
            for (int k = 0; k <= 6; ++k) {
                session.run_until(shown.time * k / 6);
                draw({160, 90});
            }
            for (const PictureSize& size : wanted) {
                draw(size);
                const std::string blocks = blocks_of(renderer_.read_back());
                std::string& golden = golden_[shown.name + (shown.has_panels ? "@" + size_text(size) : "")];
                if (new_table_ != nullptr) golden = blocks;
                EXPECT_EQ(difference(blocks, golden), "") << shown.name << ", " << size_text(size);
            }
        }
        if (new_table_ == nullptr) return;
        std::ofstream out(new_table_);
        for (const auto& [name, blocks] : golden_) out << name << ' ' << blocks << '\n';
    }

    const GlContext context_ = make_context();
    Renderer renderer_;
    std::map<std::string, std::string> golden_;
    const char* const new_table_ = std::getenv("DRAPE_GOLDEN");
};

using LongGolden = Golden;
TEST_F(LongGolden, ScenesAreThoseOfTheTable) { expect_golden(all_scenes(), std::span(sizes).first(1)); }
TEST_F(LongGolden, PanelsAreThoseOfTheTable) { expect_golden(all_panels(), std::span(sizes).first(1)); }
TEST_F(LongGolden, HelpIsThatOfTheTableWhereAWindowGrows) {
    for (const Shown& panel : all_panels()) {
        if (panel.name == "help=true") expect_golden({panel}, sizes);
    }
}

using NightlyGolden = Golden;
TEST_F(NightlyGolden, PicturesAreThoseOfTheTableAtAllSizes) {
    for (const auto& pictures : {all_scenes(), all_panels(), all_stops()}) expect_golden(pictures, sizes);
}

}  // namespace
}  // namespace drape::test
