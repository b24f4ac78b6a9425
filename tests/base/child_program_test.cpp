#include "drape/base/child_program.h"

#include <gtest/gtest.h>

#include <cerrno>
#include <csignal>

namespace drape {
namespace {

using Input = ChildProgram::Input;

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

}  // namespace
}  // namespace drape
