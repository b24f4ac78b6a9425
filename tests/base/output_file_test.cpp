#include "drape/base/output_file.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>

#include "support/input_errors.h"
#include "support/process.h"
#include "support/scratch_folder.h"

// What a file had reached when the disk was last asked to keep it.
static off_t bytes_kept = -1;

extern "C" int fsync(int descriptor) {
    struct stat file {};
    if (fstat(descriptor, &file) == 0) bytes_kept = file.st_size;
    return static_cast<int>(syscall(SYS_fsync, descriptor));
}

namespace drape {
namespace {

namespace fs = std::filesystem;
using test::input_error_of;
using test::read_file;
using test::run_error_of;
using testing::ElementsAre;

class OutputFileTest : public testing::Test {
protected:
    [[nodiscard]] std::string path(const std::string& name) const { return (folder_ / name).string(); }
    void put(const std::string& name, const std::string& text) const { std::ofstream(path(name)) << text; }

    [[nodiscard]] std::vector<std::string> names() const { return test::names_in(folder_); }

    const ScratchFolder scratch_;
    const fs::path& folder_ = scratch_.path();
};

/// Does `work` in a process, which it is to kill in the end.
template <class Work>
void in_killed_process(Work work) {
    const pid_t child = fork();
    if (child == 0) {
        work();
        _exit(1);
    }
    int status = 0;
    waitpid(child, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status));
}

TEST_F(OutputFileTest, ReachesTheDiskBeforeItHasItsName) {
    for (const char* name : {"a.txt", "b.txt"}) {
        put("a.txt", "before");
        OutputFile file(path(name));
        file.stream() << "a line\n";
        file.flush();
        bytes_kept = -1;
        fs::remove(path("b.txt"));
        name[0] == 'a' ? file.close() : static_cast<void>(file.close_if_free());
        EXPECT_EQ(bytes_kept, 7) << name;
        EXPECT_EQ(read_file(path(name)), "a line\n");
    }
    EXPECT_THAT(names(), ElementsAre("a.txt", "b.txt"));
    OutputFile none("");
    EXPECT_FALSE(none.wanted());
    EXPECT_NO_THROW(none.close());
}

TEST_F(OutputFileTest, TouchesNothingThatWasThereBeforeItIsClosed) {
    put("a.txt", "before");
    {
        OutputFile file(path("a.txt"));
        file.stream() << "after" << std::flush;
        EXPECT_EQ(read_file(path("a.txt")), "before");
    }
    EXPECT_EQ(read_file(path("a.txt")), "before") << "it was never closed";
    EXPECT_THAT(names(), ElementsAre("a.txt"));
}

TEST_F(OutputFileTest, KeepsTheModeOfTheFileBefore) {
    put("a.txt", "before");
    ASSERT_EQ(chmod(path("a.txt").c_str(), 0640), 0);
    OutputFile file(path("a.txt"));
    for (const auto& entry : fs::directory_iterator(folder_)) {
        EXPECT_EQ(entry.status().permissions(), static_cast<fs::perms>(0640)) << entry << " may not be read meanwhile";
    }
    file.close();
    EXPECT_EQ(fs::status(path("a.txt")).permissions(), static_cast<fs::perms>(0640));
}

TEST_F(OutputFileTest, WritesThroughLinksAlsoWhereTheyLeadToNothingYet) {
    fs::create_directory(path("far"));
    put("far/a.txt", "before");
    fs::create_symlink("far/a.txt", path("link"));
    fs::create_symlink("far/b.txt", path("to-come"));
    for (const char* name : {"link", "to-come"}) {
        OutputFile file(path(name));
        file.stream() << "after";
        file.close();
        EXPECT_TRUE(fs::is_symlink(path(name)));
    }
    EXPECT_EQ(read_file(path("far/a.txt")), "after");
    EXPECT_EQ(read_file(path("far/b.txt")), "after");
    EXPECT_EQ(std::distance(fs::directory_iterator(path("far")), fs::directory_iterator()), 2);
}

TEST_F(OutputFileTest, RemovesWhatAKilledRunOfTheSameFileHasLeft) {
    put("a.txt", "before");
    in_killed_process([&] {
        OutputFile one(path("a.txt")), other(path("b.txt"));
        one.stream() << "half" << std::flush;
        raise(SIGKILL);
    });
    ASSERT_THAT(names(), ElementsAre(".a.drape.txt", ".b.drape.txt", "a.txt"));
    OutputFile(path("a.txt")).close();
    EXPECT_THAT(names(), ElementsAre(".b.drape.txt", "a.txt")) << "and nothing of another file";
    EXPECT_EQ(read_file(path("a.txt")), "");
}

TEST_F(OutputFileTest, IsNotWrittenByTwoAtATime) {
    OutputFile first(path("a.txt"));
    first.stream() << "first";
    EXPECT_THAT(run_error_of([&] { OutputFile(path("a.txt")); }), testing::HasSubstr("another run is writing "));
    first.close();
    EXPECT_EQ(read_file(path("a.txt")), "first");
}

TEST_F(OutputFileTest, TakesAnyNameThatAFileMayHave) {
    for (const std::string& name : {std::string(255, 'x'), "a." + std::string(253, 'y'), std::string(".hidden"),
                                    std::string("no extension"), std::string("two.tar.gz")}) {
        OutputFile(path(name)).close();
        EXPECT_THAT(names(), ElementsAre(name));
        fs::remove(path(name));
    }
}

TEST_F(OutputFileTest, ThatIsOnlyToBeNewReplacesNothing) {
    OutputFile file(path("a.txt"));
    put("a.txt", "made meanwhile");
    EXPECT_FALSE(file.close_if_free());
    EXPECT_EQ(read_file(path("a.txt")), "made meanwhile");
}

TEST_F(OutputFileTest, ThatIsKeptHasAReadableNameUntilItIsClosedAndLosesNothingOfAKilledRun) {
    using LeftOver = OutputFile::LeftOver;
    put("r.txt", "before");
    in_killed_process([&] {
        OutputFile file(path("r.txt"), LeftOver::Keep);
        file.stream() << "half" << std::flush;
        raise(SIGKILL);
    });
    EXPECT_THAT(names(), ElementsAre("r.txt", "r.txt.unfinished"));
    {
        OutputFile file(path("r.txt"), LeftOver::Keep);
        EXPECT_EQ(file.set_aside(), path("r.txt-1.unfinished"));
        EXPECT_THROW(OutputFile(path("r.txt"), LeftOver::Keep), RunError) << "one at a time";
        EXPECT_EQ(read_file(path("r.txt")), "before");
        file.close();
    }
    EXPECT_THAT(names(), ElementsAre("r.txt", "r.txt-1.unfinished"));
    EXPECT_EQ(read_file(path("r.txt-1.unfinished")), "half");
}

TEST_F(OutputFileTest, ThatCannotBeWrittenIsNamedBeforeAnyWork) {
    for (const std::string& name : {std::string("/no/such/folder/state.csv"), folder_.string()}) {
        EXPECT_THAT(run_error_of([&] { OutputFile file(name); }), testing::StartsWith(name + ": cannot be written: "));
    }
    if (geteuid() == 0) return;
    put("a.txt", "before");
    ASSERT_EQ(chmod(path("a.txt").c_str(), 0400), 0);
    EXPECT_THROW(OutputFile(path("a.txt")), RunError) << "its folder may be written, but not it";
}

TEST_F(OutputFileTest, OnAFullDiskIsNamedWhenItIsClosed) {
    if (!fs::exists("/dev/full")) GTEST_SKIP() << "no device that is always full";
    OutputFile file("/dev/full");
    file.stream() << "a line\n";
    EXPECT_THAT(run_error_of([&] { file.close(); }), testing::HasSubstr("No space left"));
    EXPECT_TRUE(fs::is_character_file("/dev/full"));
}

TEST_F(OutputFileTest, WritesAFifoDirectly) {
    ASSERT_EQ(mkfifo(path("pipe").c_str(), 0600), 0);
    const int reader = open(path("pipe").c_str(), O_RDONLY | O_NONBLOCK);
    OutputFile file(path("pipe"));
    file.stream() << "a line";
    file.close();
    std::array<char, 16> text{};
    EXPECT_EQ(read(reader, text.data(), text.size()), 6);
    close(reader);
    EXPECT_TRUE(fs::is_fifo(path("pipe")));
}

TEST_F(OutputFileTest, NamedAsStandardOutputWritesWhereThatIs) {
    // As /dev/stdout is, which a fault could replace on the whole machine
    fs::create_symlink("/proc/self/fd/1", path("stdout"));
    const pid_t child = fork();
    if (child == 0) {
        dup2(open(path("out").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDOUT_FILENO);
        bool whole = write(STDOUT_FILENO, "one\n", 4) == 4;
        OutputFile file(path("stdout"));
        file.stream() << "two\n";
        file.close();
        whole &= write(STDOUT_FILENO, "three\n", 6) == 6;
        _exit(whole ? 0 : 1);
    }
    int status = 0;
    waitpid(child, &status, 0);
    EXPECT_EQ(status, 0);
    EXPECT_EQ(read_file(path("out")), "one\ntwo\nthree\n");
    EXPECT_THAT(names(), ElementsAre("out", "stdout"));
    EXPECT_TRUE(fs::is_symlink(path("stdout")));
}

/// Files that a command line names.
class NamedFiles : public testing::Test {
protected:
    NamedFiles() {
        fs::create_directories(folder_ / "inner");
        std::ofstream(folder_ / "there") << "text";
        fs::create_hard_link(folder_ / "there", folder_ / "hard");
        fs::create_symlink("there", folder_ / "soft");
        fs::create_symlink("to-come", folder_ / "dangling");
        fs::create_symlink(".", folder_ / "round");
    }

    /// What is said of two files that are written.
    [[nodiscard]] std::string refusal(const std::string& one, const std::string& other) const {
        return input_error_of([&] {
            check_apart({{"--state", folder_ / one}, {"--none", ""}, {"--stats", folder_ / other}});
        });
    }

    const ScratchFolder scratch_;
    const fs::path& folder_ = scratch_.path();
};

TEST_F(NamedFiles, ThatAreOneAreRefusedWhateverTheyAreCalled) {
    const std::pair<const char*, const char*> same[] = {
        {"there", "there"},   {"there", "./there"},    {"there", "inner/../there"},
        {"there", "soft"},    {"soft", "hard"},        {"there", "round/there"},
        {"new", "new"},       {"new", "./new"},        {"new", "inner/../new"},
        {"round/new", "new"}, {"dangling", "to-come"}, {"no/folder", "no/./folder"}};
    for (const auto& [one, other] : same) {
        const std::string said = refusal(one, other);
        EXPECT_THAT(said, testing::StartsWith("--state ")) << one << " and " << other;
        EXPECT_THAT(said, testing::HasSubstr(" and --stats ")) << one << " and " << other;
    }
    for (const char* other : {"other", "inner/there", "THERE", "inner/new"}) {
        EXPECT_NO_THROW(check_apart({{"--state", folder_ / "there"}, {"--stats", folder_ / other}})) << other;
    }
}

TEST_F(NamedFiles, MayBeReadTwiceButNotReadAndWritten) {
    EXPECT_NO_THROW(check_apart({{"--state", "/dev/null"}, {"--stats", "/dev/null"}})) << "a device";
    const fs::path file = folder_ / "there";
    EXPECT_NO_THROW(check_apart({{"SCENE", file, NamedFile::Use::Read}, {"--replay", file, NamedFile::Use::Read}}));
    EXPECT_THROW(check_apart({{"SCENE", file, NamedFile::Use::Read}, {"--record", folder_ / "soft"}}), InputError);
    EXPECT_THROW(check_apart({{"--record", folder_ / "soft"}, {"SCENE", file, NamedFile::Use::Read}}), InputError);
}

}  // namespace
}  // namespace drape
