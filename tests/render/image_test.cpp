#include "drape/render/image.h"

#include <gtest/gtest.h>

#include <fstream>

#include "drape/base/input_error.h"
#include "support/process.h"
#include "support/read_png.h"
#include "support/scratch_folder.h"

namespace drape {
namespace {

namespace fs = std::filesystem;

class ImageFile : public testing::Test {
protected:
    static Image noise(int width, int height) {
        Image image{width, height, std::vector<std::uint8_t>(static_cast<std::size_t>(3 * width * height))};
        std::uint32_t seed = 7;
        for (std::uint8_t& byte : image.rgb)
            byte = static_cast<std::uint8_t>((seed = seed * 1664525u + 1013904223u) >> 24);
        return image;
    }

    [[nodiscard]] std::ptrdiff_t files() const {
        return std::distance(fs::directory_iterator(folder_), fs::directory_iterator());
    }

    const ScratchFolder scratch_;
    const fs::path folder_ = scratch_.path();
};

TEST_F(ImageFile, ReadsBackAsItWasWrittenWithTexts) {
    Image image = noise(37, 21);
    image.texts = {{"Scene", "drop"}, {"Settings", "title = \"Tuch \u00e4\"\n[cloth]\n"}};
    write_png(image, folder_ / "a.png");
    const Image read = read_png(folder_ / "a.png");
    EXPECT_EQ(read.width, 37);
    EXPECT_EQ(read.height, 21);
    EXPECT_EQ(read.rgb, image.rgb);
    EXPECT_EQ(files(), 1);
    const std::string bytes = test::read_file(folder_ / "a.png");
    for (const ImageText& text : image.texts) {
        EXPECT_NE(bytes.find("iTXt" + text.keyword + std::string(5, '\0') + text.text), std::string::npos);
    }
}

TEST_F(ImageFile, RefusesWhatIsNoPictureAndSaysWhichFileCannotBeWritten) {
    try {
        write_png(noise(4, 4), folder_ / "missing" / "a.png");
        FAIL();
    } catch (const RunError& error) {
        EXPECT_NE(std::string(error.what()).find("missing/a.png"), std::string::npos);
    }
    std::ofstream(folder_ / "a.png") << "no picture";
    EXPECT_THROW(read_png(folder_ / "a.png"), InputError);
    EXPECT_THROW(read_png(folder_ / "none.png"), InputError);
}

}  // namespace
}  // namespace drape
