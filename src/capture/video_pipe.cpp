#include "video_pipe.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <utility>
#include <vector>

#include "drape/base/numbers.h"

extern char** environ;

namespace drape {

namespace {

std::vector<std::string> command_line(const std::filesystem::path& file, int width, int height, double rate) {
    const std::string size = std::to_string(width) + "x" + std::to_string(height);
    // Most players want even sides and this pixel format
    return {"ffmpeg",
            "-y",
            "-nostdin",
            "-loglevel",
            "error",
            "-f",
            "rawvideo",
            "-pixel_format",
            "rgb24",
            "-video_size",
            size,
            "-framerate",
            real_text(rate),
            "-i",
            "pipe:0",
            "-vf",
            "pad=ceil(iw/2)*2:ceil(ih/2)*2",
            "-pix_fmt",
            "yuv420p",
            std::filesystem::absolute(file).string()};
}

}  // namespace

VideoPipe::VideoPipe(const std::filesystem::path& file, int width, int height, double rate) {
    std::signal(SIGPIPE, SIG_IGN);
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) {
        trouble_ = std::string("no pipe to ffmpeg: ") + std::strerror(errno);
        return;
    }
    std::vector<std::string> words = command_line(file, width, height, rate);
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);

    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[0], STDIN_FILENO);
    const int error = posix_spawnp(&process_, "ffmpeg", &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    ::close(ends[0]);
    input_ = ends[1];
    if (error != 0) {
        process_ = -1;
        stop_feeding();
        trouble_ = std::string("ffmpeg could not be started: ") + std::strerror(error);
    }
}

VideoPipe::~VideoPipe() { close(); }

void VideoPipe::write(const Image& image) {
    const std::uint8_t* data = image.rgb.data();
    std::size_t left = image.rgb.size();
    while (left > 0 && input_ >= 0) {
        const ssize_t written = ::write(input_, data, left);
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return close();
        data += written;
        left -= static_cast<std::size_t>(written);
    }
}

void VideoPipe::stop_feeding() {
    if (input_ >= 0) ::close(std::exchange(input_, -1));
}

void VideoPipe::close() {
    stop_feeding();
    if (process_ < 0) return;
    int status = 0;
    pid_t ended = 0;
    do {
        ended = waitpid(process_, &status, 0);
    } while (ended < 0 && errno == EINTR);
    process_ = -1;
    if (ended > 0 && WIFEXITED(status) && WEXITSTATUS(status) == 0) return;
    if (WIFSIGNALED(status)) {
        trouble_ = "ffmpeg was ended by signal " + std::to_string(WTERMSIG(status));
    } else {
        trouble_ = "ffmpeg failed with status " + std::to_string(WEXITSTATUS(status));
    }
}

}  // namespace drape
