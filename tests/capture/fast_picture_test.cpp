// Pictures that are drawn fast, beside those that are drawn in full.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "drape/render/image.h"
#include "program.h"

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

TEST(FastPicture, ShowsWhatAFullOneDoesButCoarserAndTextAsSharp) {
    const TestFolder folder;
    for (const std::string size : {"640x360", "641x363"}) {
        const auto draw = [&](const std::string& quality) {
            const std::vector<std::string> words{"drop",
                                                 "--frames",
                                                 "90",
                                                 "--every",
                                                 "90",
                                                 "--size",
                                                 size,
                                                 "--out",
                                                 folder / "a",
                                                 "--again",
                                                 "--overlay",
                                                 "--set",
                                                 "view.quality=" + quality,
                                                 "view.bounds=true"};
            EXPECT_EQ(run_program("drape-capture", words).exit_code, 0);
            return read_png(folder / "a/frame_0090.png");
        };
        const Image full = draw("full"), fast = draw("fast");
        ASSERT_EQ(full.width, fast.width);
        ASSERT_EQ(full.height, fast.height);
        EXPECT_GT(difference_of(full, fast, 1), 0.8) << "nothing is coarser";
        EXPECT_LT(difference_of(full, fast, 16), 0.5) << "as if moved by a pixel, or lighter or darker";

        int most = 0;  // of the panel with figures
        for (int pixel = 0; pixel < 150 * 50; ++pixel) {
            const int x = pixel % 150, y = pixel / 150;
            for (int c = 0; c < 3; ++c) most = std::max(most, std::abs(full.pixel(x, y)[c] - fast.pixel(x, y)[c]));
        }
        EXPECT_LT(most, 16) << "text is bright on dark";
    }
}

}  // namespace
}  // namespace drape::test
