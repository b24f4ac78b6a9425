#include "drape/base/input_file.h"

#include <gmock/gmock.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <sstream>

#include "support/input_errors.h"
#include "support/scratch_file.h"

namespace drape {
namespace {

using test::input_error_of;
using test::ScratchFile;
using testing::HasSubstr;
using testing::StartsWith;

/// What is said of a file that is read whole.
std::string file_complaint(const std::string& name, std::uintmax_t largest = UINTMAX_MAX) {
    return input_error_of([&] { static_cast<void>(read_text(name, largest)); });
}

/// A pipe that this process has open, with a text in it.
class FullPipe {
public:
    explicit FullPipe(const std::string& text) {
        EXPECT_EQ(pipe(ends_.data()), 0);
        EXPECT_EQ(write(ends_[1], text.data(), text.size()), static_cast<ssize_t>(text.size()));
        close(ends_[1]);
    }
    ~FullPipe() { close(ends_[0]); }
    FullPipe(const FullPipe&) = delete;
    FullPipe& operator=(const FullPipe&) = delete;

    [[nodiscard]] std::string name() const { return "/dev/fd/" + std::to_string(ends_[0]); }

private:
    std::array<int, 2> ends_{};
};

TEST(InputFile, IsReadWhole) {
    std::string text;
    for (int i = 0; i < 50'000; ++i) text += std::to_string(i) + "\n";
    const ScratchFile file("input.txt", text);
    EXPECT_EQ(read_text(file.name()), text);
    EXPECT_EQ(read_text(file.name(), text.size()), text);
}

TEST(InputFile, ThatIsTooLargeIsRefusedBeforeItIsRead) {
    const ScratchFile file("input.txt", "0123456789");
    EXPECT_EQ(file_complaint(file.name(), 9), file.name() + ": 10 bytes: allowed at most 9");
}

TEST(InputFile, ThatIsMissingIsNamedWithTheReason) {
    EXPECT_EQ(file_complaint("/no/such/file"), "/no/such/file: cannot be read: No such file or directory");
    EXPECT_THAT(file_complaint(""), HasSubstr("cannot be read"));
}

TEST(InputFile, MayBeNoFolderAndNoDevice) {
    EXPECT_EQ(file_complaint(testing::TempDir()), testing::TempDir() + ": is a folder: allowed a regular file");
    EXPECT_EQ(file_complaint("/dev/zero"), "/dev/zero: is a device: allowed a regular file");
}

TEST(InputFile, NeverWaitsForTheOtherEndOfAPipe) {
    const ScratchFile file("pipe");
    ASSERT_EQ(mkfifo(file.name().c_str(), 0600), 0);
    alarm(20);  // ends the tests where opening waits
    EXPECT_EQ(file_complaint(file.name()), file.name() + ": is a pipe: allowed a regular file");
    alarm(0);
}

TEST(InputFile, MayBeAPipeThatTheShellHasOpened) {
    const FullPipe pipe("0,0,0\n1,0,0\n");
    EXPECT_EQ(read_text(pipe.name()), "0,0,0\n1,0,0\n");
}

TEST(InputFile, OfMoreBytesThanAPipeMayHaveIsRefusedWhileItIsRead) {
    const FullPipe pipe("0123456789");
    EXPECT_EQ(file_complaint(pipe.name(), 9), pipe.name() + ": has more bytes than are allowed");
}

TEST(ReadLine, TakesTheEndsOfLinesOfOtherSystemsForEnds) {
    std::istringstream in("one\r\n\r\ntwo\rthree\r\nfour\r");
    std::string line;
    EXPECT_EQ(read_line(in, line, 100), LineEnd::Whole);
    EXPECT_EQ(line, "one");
    EXPECT_EQ(read_line(in, line, 100), LineEnd::Whole);
    EXPECT_EQ(line, "");
    EXPECT_EQ(read_line(in, line, 100), LineEnd::Whole);
    EXPECT_EQ(line, "two\rthree") << "only at the end of a line";
    EXPECT_EQ(read_line(in, line, 100), LineEnd::CutOff);
    EXPECT_EQ(line, "four");
    EXPECT_EQ(read_line(in, line, 100), LineEnd::None);
}

}  // namespace
}  // namespace drape
