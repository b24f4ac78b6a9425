// Numbered pictures, encoded in a thread of their own, without a picture of OpenGL's.

#include "capture/frame_writer.h"

#include <gmock/gmock.h>
#include <sys/resource.h>

#include <csignal>

#include "drape/base/output_file.h"
#include "support/input_errors.h"
#include "support/process.h"
#include "support/read_png.h"
#include "support/scratch_folder.h"

namespace drape {
namespace {

namespace fs = std::filesystem;
using test::run_error_of;
using ::testing::AllOf;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;

class FrameWriterTest : public testing::Test {
protected:
    // Noise that cannot be made smaller: more bytes than the writer's trial file has.
    static std::shared_ptr<const Image> noise(unsigned seed) {
        Image image{400, 300, std::vector<std::uint8_t>(3 * 400 * 300)};
        for (std::uint8_t& byte : image.rgb) byte = static_cast<std::uint8_t>((seed = seed * 1664525u + 1u) >> 24);
        return std::make_shared<const Image>(std::move(image));
    }

    static std::shared_ptr<const Image> grey() {
        return std::make_shared<const Image>(Image{64, 48, std::vector<std::uint8_t>(3 * 64 * 48, 128)});
    }

    [[nodiscard]] std::vector<std::string> names() const { return test::names_in(folder_.path()); }

    [[nodiscard]] std::string file(const std::string& name) const { return (folder_.path() / name).string(); }

    ScratchFolder folder_;
};

TEST_F(FrameWriterTest, WritesEachPictureWhileTheNextIsMade) {
    constexpr int frames = 12;
    {
        FrameWriter writer(folder_.path(), frames, false);
        for (int frame = 1; frame <= frames; ++frame) writer.write(noise(static_cast<unsigned>(frame)), frame);
        writer.finish();
        EXPECT_EQ(writer.last().string(), file("frame_0012.png"));
    }
    ASSERT_EQ(names().size(), std::size_t(frames)) << "and nothing else";
    for (int frame = 1; frame <= frames; ++frame) {
        const std::string number = std::to_string(frame);
        const Image read = read_png(file("frame_" + std::string(4 - number.size(), '0') + number + ".png"));
        EXPECT_EQ(read.rgb, noise(static_cast<unsigned>(frame))->rgb) << frame;
    }
}

TEST_F(FrameWriterTest, LeavesAloneATableThatIsBeingWrittenAmongThem) {
    OutputFile table(file("frame_times.csv"));
    table.stream() << "1" << std::flush;
    FrameWriter writer(folder_.path(), 1, false);
    table.close();
    EXPECT_THAT(names(), ::testing::Contains("frame_times.csv"));
}

TEST_F(FrameWriterTest, LetsTheFolderGoOnlyWhenTheLastPictureIsWritten) {
    {
        FrameWriter writer(folder_.path(), 1, false);
        writer.write(noise(1), 1);
    }
    EXPECT_EQ(read_png(file("frame_0001.png")).rgb, noise(1)->rgb) << "nobody waited for it";
    EXPECT_THAT(names(), ::testing::ElementsAre("frame_0001.png"));
}

TEST_F(FrameWriterTest, NamesThePictureThatDoesNotFitAndTheLastGoodOne) {
    for (const bool goes_on : {true, false}) {
        FrameWriter writer(folder_.path(), 3, true);
        writer.write(grey(), 1);
        writer.finish();

        // A limit on the size of files stands for a full disk
        const auto before_signal = std::signal(SIGXFSZ, SIG_IGN);
        rlimit before{};
        getrlimit(RLIMIT_FSIZE, &before);
        rlimit limit = before;
        limit.rlim_cur = 220'000;
        setrlimit(RLIMIT_FSIZE, &limit);
        writer.write(noise(2), 2);
        const std::string said = run_error_of([&] { goes_on ? writer.write(grey(), 3) : writer.finish(); });
        setrlimit(RLIMIT_FSIZE, &before);
        std::signal(SIGXFSZ, before_signal);

        EXPECT_THAT(said, AllOf(HasSubstr(file("frame_0002.png") + ": could not be written whole: File too large"),
                                EndsWith("; the last good frame is " + file("frame_0001.png")), Not(HasSubstr("\n"))));
        EXPECT_THAT(names(), ::testing::ElementsAre(".frames.drape.lock", "frame_0001.png")) << "no part of it is left";
        EXPECT_EQ(writer.last().string(), file("frame_0001.png"));
        writer.finish();  // has nothing more to say
    }
}

TEST_F(FrameWriterTest, SaysThatNoPictureWasWritten) {
    FrameWriter writer(folder_.path(), 1, false);
    fs::create_directory(file("frame_0001.png"));  // no file can take this name
    writer.write(grey(), 1);
    EXPECT_THAT(run_error_of([&] { writer.finish(); }),
                AllOf(HasSubstr(file("frame_0001.png") + ": "), EndsWith("; no frame was written")));
    EXPECT_TRUE(writer.last().empty());
}

}  // namespace
}  // namespace drape
