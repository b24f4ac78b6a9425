#include "drape/render/image.h"

#include <gtest/gtest.h>
#include <png.h>
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

/// The texts of a PNG, as libpng reads them.
std::vector<ImageText> texts_of(const fs::path& file) {
    FILE* in = std::fopen(file.c_str(), "rb");
    png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    std::vector<ImageText> texts;
    // libpng leaps here from an error
    if (setjmp(png_jmpbuf(png)) == 0) {
        png_set_crc_action(png, PNG_CRC_ERROR_QUIT, PNG_CRC_ERROR_QUIT);
        png_init_io(png, in);
        png_read_info(png, info);
        png_textp found = nullptr;
        const int count = png_get_text(png, info, &found, nullptr);
        for (int i = 0; i < count; ++i) texts.push_back({found[i].key, found[i].text});
    }
    png_destroy_read_struct(&png, &info, nullptr);
    std::fclose(in);
    return texts;
}

TEST_F(ImageFile, CarriesTexts) {
    Image image = noise(5, 4);
    image.texts = {{"Scene", "drop"}, {"Settings", "title = \"Tuch \u00e4\"\n[cloth]\n"}};
    write_png(image, folder_ / "a.png");
    const std::vector<ImageText> texts = texts_of(folder_ / "a.png");
    ASSERT_EQ(texts.size(), 2u);
    EXPECT_EQ(texts[0].keyword, "Scene");
    EXPECT_EQ(texts[0].text, "drop");
    EXPECT_EQ(texts[1].text, image.texts[1].text);
    EXPECT_EQ(read_png(folder_ / "a.png").rgb, image.rgb);
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
