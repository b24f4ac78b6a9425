#include "drape/base/child_program.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>

#include "support/process.h"
#include "support/scratch_file.h"

namespace drape {
namespace {

using Input = ChildProgram::Input;
using test::read_file;
using test::ScratchFile;

TEST(ChildProgram, TellsHowItEnded) {
    EXPECT_EQ(run_child({"sh", "-c", "exit 7"}), 7);
    EXPECT_EQ(run_child({"sh", "-c", "kill -TERM $$"}), 128 + SIGTERM);
    EXPECT_EQ(run_child({"no-such-program-anywhere"}), std::nullopt);
    EXPECT_EQ(ChildProgram({"no-such-program-anywhere"}, Input::Fed).error(), ENOENT);
}

TEST(ChildProgram, InheritsNoSignalThatIsBlockedOrIgnoredHere) {
    sigset_t blocked, before;
    sigemptyset(&blocked);
    sigaddset(&blocked, SIGTERM);
    pthread_sigmask(SIG_BLOCK, &blocked, &before);
    const auto pipe_before = std::signal(SIGPIPE, SIG_IGN), size_before = std::signal(SIGXFSZ, SIG_IGN);
    for (const Input input : {Input::Shared, Input::Fed}) {
        for (const char* number : {"TERM", "PIPE", "XFSZ"}) {
            ChildProgram child({"sh", "-c", std::string("kill -") + number + " $$; exit 0"}, input);
            EXPECT_GT(child.wait(), 128) << number;
        }
    }
    std::signal(SIGPIPE, pipe_before);
    std::signal(SIGXFSZ, size_before);
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

TEST(ChildProgram, ReadsWhatItIsFed) {
    const ScratchFile file("fed");
    ChildProgram child({"sh", "-c", "cat > '" + file.name() + "'"}, Input::Fed);
    ASSERT_EQ(write(child.feed(), "text", 4), 4);
    child.end_feed();
    EXPECT_EQ(child.wait(), 0);
    EXPECT_EQ(read_file(file.name()), "text");
}

TEST(ChildProgram, IsKilledEvenIfItIsStopped) {
    ChildProgram child({"sh", "-c", "kill -STOP $$"}, Input::Fed);
    EXPECT_EQ(child.wait(0.05), std::nullopt);
    child.kill();
    EXPECT_EQ(child.wait(), 128 + SIGKILL);
}

}  // namespace
}  // namespace drape
