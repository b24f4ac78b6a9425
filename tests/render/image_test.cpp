#include "drape/render/image.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <fstream>

#include "drape/base/input_error.h"

namespace drape {
namespace {

namespace fs = std::filesystem;

class ImageFile : public testing::Test {
protected:
    ImageFile() { fs::create_directories(folder_); }
    ~ImageFile() override {
        fs::permissions(folder_, fs::perms::owner_all);
        fs::remove_all(folder_);
    }

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

    const fs::path folder_ = fs::path(testing::TempDir()) / ("drape-image-" + std::to_string(::getpid()));
};

TEST_F(ImageFile, ReadsBackAsItWasWritten) {
    const Image image = noise(37, 21);
    write_png(image, folder_ / "a.png");
    const Image read = read_png(folder_ / "a.png");
    EXPECT_EQ(read.width, 37);
    EXPECT_EQ(read.height, 21);
    EXPECT_EQ(read.rgb, image.rgb);
    EXPECT_EQ(files(), 1);
}

TEST_F(ImageFile, KeepsTheOldPictureIfTheNewOneDoesNotFit) {
    const fs::path file = folder_ / "a.png";
    write_png(noise(8, 8), file);

    // A limit on the size of files stands for a full disk
    std::signal(SIGXFSZ, SIG_IGN);
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    rlimit small = before;
    small.rlim_cur = 4096;
    setrlimit(RLIMIT_FSIZE, &small);
    EXPECT_THROW(write_png(noise(200, 200), file), RunError);
    setrlimit(RLIMIT_FSIZE, &before);

    EXPECT_EQ(read_png(file).width, 8);
    EXPECT_EQ(files(), 1) << "a part of a picture was left behind";
}

TEST_F(ImageFile, SaysWhichFileCannotBeWritten) {
    try {
        write_png(noise(4, 4), folder_ / "missing" / "a.png");
        FAIL();
    } catch (const RunError& error) {
        EXPECT_NE(std::string(error.what()).find("missing/a.png"), std::string::npos);
    }
}

TEST_F(ImageFile, RefusesWhatIsNoPicture) {
    std::ofstream(folder_ / "a.png") << "no picture";
    EXPECT_THROW(read_png(folder_ / "a.png"), InputError);
    EXPECT_THROW(read_png(folder_ / "none.png"), InputError);
}

}  // namespace
}  // namespace drape
