// Pictures that are drawn fast, beside those that are drawn in full.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "drape/render/image.h"
#include "program.h"
#include "support/read_png.h"

namespace drape::test {
namespace {

/// By how much the averages of squares of so many pixels differ in two pictures, of 255, on average.
double difference_of(const Image& one, const Image& other, int side) {
    double sum = 0;
    int squares = 0;
    for (int top = 0; top + side <= one.height; top += side) {
        for (int left = 0; left + side <= one.width; left += side, ++squares) {
            double apart = 0;
            for (int pixel = 0; pixel < side * side; ++pixel) {
                const int x = left + pixel % side, y = top + pixel / side;
                for (int c = 0; c < 3; ++c) apart += one.pixel(x, y)[c] - other.pixel(x, y)[c];
            }
            sum += std::abs(apart) / (3 * side * side);
        }
    }
    return sum / squares;
}

/// How far a strip of one picture looks moved in the other, along x or along y [pixel]: the move of the least
/// difference, up to two pixels.
int move_of(const Image& one, const Image& other, bool along_x, int from, int to) {
    constexpr int most = 2;
    const auto difference = [&](int move) {
        const int dx = along_x ? move : 0, dy = along_x ? 0 : move;
        long sum = 0;
        for (int y = along_x ? most : from; y < (along_x ? one.height - most : to); ++y) {
            for (int x = along_x ? from : most; x < (along_x ? to : one.width - most); ++x) {
                for (int c = 0; c < 3; ++c) sum += std::abs(one.pixel(x, y)[c] - other.pixel(x + dx, y + dy)[c]);
            }
        }
        return sum;
    };
    int least = -most;
    for (int move = -most; move <= most; ++move) {
        if (difference(move) < difference(least)) least = move;
    }
    return least;
}

/// One frame of the scene.
Image frame_of(const std::string& size, const std::string& frame, const Words& changes) {
    const TestFolder folder;
    const Words words{"drop", "--frames", frame, "--every", frame, "--size", size, "--out", folder / "a", "--set"};
    EXPECT_EQ(run_program("drape-capture", joined(words, changes)).exit_code, 0);
    return read_png(folder / ("a/frame_00" + frame + ".png"));
}

// 641 is magnified from 321 and 361 from 181: by less than two
TEST(FastPicture, IsMagnifiedUpToItsLastPixelWhereItsSizeIsOdd) {
    const auto draw = [](const std::string& quality) {
        return frame_of("641x361", "60", {"view.eye=0.5,0.5,0.6", "view.colour=level", "view.quality=" + quality});
    };
    const Image full = draw("full"), fast = draw("fast");
    for (const int from : {2, 270, 539}) EXPECT_EQ(move_of(full, fast, true, from, from + 100), 0) << "column " << from;
    for (const int from : {2, 150, 299}) EXPECT_EQ(move_of(full, fast, false, from, from + 60), 0) << "row " << from;
}

TEST(FastPicture, ShowsWhatAFullOneDoesButCoarserAndTextAsSharp) {
    const Image full = frame_of("641x363", "90", {"view.bounds=true", "view.quality=full", "--overlay"});
    const Image fast = frame_of("641x363", "90", {"view.bounds=true", "view.quality=fast", "--overlay"});
    ASSERT_EQ(full.width, fast.width);
    ASSERT_EQ(full.height, fast.height);
    EXPECT_GT(difference_of(full, fast, 1), 0.8) << "nothing is coarser";
    EXPECT_LT(difference_of(full, fast, 16), 0.5) << "as if moved by a pixel, or lighter or darker";

    int most = 0;  // of the panel, above the frames a second
    for (int pixel = 0; pixel < 150 * 30; ++pixel) {
        const int x = pixel % 150, y = pixel / 150;
        for (int c = 0; c < 3; ++c) most = std::max(most, std::abs(full.pixel(x, y)[c] - fast.pixel(x, y)[c]));
    }
    EXPECT_LT(most, 16) << "text is bright on dark";
}

}  // namespace
}  // namespace drape::test
