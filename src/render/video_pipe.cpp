#include "drape/render/video_pipe.h"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <iterator>
#include <sstream>
#include <vector>

#include "drape/base/input_error.h"
#include "drape/base/numbers.h"
#include "drape/base/stopwatch.h"

namespace drape {

namespace {

constexpr double patience = 5;  // s that ffmpeg may stand still where nobody waits for it
constexpr double glance = 0.1;  // s between two looks for a signal

// Formats that are one file each
const std::array<std::string, 9> extensions{".mp4", ".m4v", ".mov", ".mkv", ".webm", ".avi", ".gif", ".ogv", ".mpg"};

std::vector<std::string> command_line(const std::filesystem::path& file, PictureSize size, double rate) {
    // Most players want even sides and this pixel format
    std::istringstream words("ffmpeg -y -nostdin -loglevel error -f rawvideo -pixel_format rgb24 -video_size " +
                             size_text(size) + " -framerate " + real_text(rate) +
                             " -i pipe:0 -vf pad=ceil(iw/2)*2:ceil(ih/2)*2 -pix_fmt yuv420p");
    std::vector<std::string> line{std::istream_iterator<std::string>(words), {}};
    line.push_back(file.string());
    return line;
}

}  // namespace

void check_video_name(const std::string& option, const std::filesystem::path& file) {
    std::string extension = file.extension().string();
    for (char& c : extension) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    if (file.empty() || std::ranges::find(extensions, extension) != extensions.end()) return;
    throw InputError(option + " " + shortened(file.string()) + ": allowed a name that ends in " + listed(extensions));
}

VideoPipe::VideoPipe(const std::filesystem::path& file, PictureSize size, double rate, const StopSignals& signals,
                     Use use, double end_patience)
    : signals_(signals), use_(use), end_patience_(end_patience), name_(file), file_(file) {
    std::signal(SIGPIPE, SIG_IGN);
    ffmpeg_.emplace(command_line(file_.name(), size, rate), ChildProgram::Input::Fed);
    if (ffmpeg_->error() == 0) return;
    error_ = std::string("ffmpeg (Debian package ffmpeg) could not be started: ") + std::strerror(ffmpeg_->error());
    ffmpeg_.reset();
}

/// A run that ends by an exception has no video to give a name to.
VideoPipe::~VideoPipe() {
    fed_ = false;
    close();
}

void VideoPipe::write(const Image& image) {
    const std::uint8_t* data = image.rgb.data();
    std::size_t left = image.rgb.size();
    double waited = 0;
    while (left > 0 && ffmpeg_) {
        const ssize_t written = ::write(ffmpeg_->feed(), data, left);
        if (written > 0) {
            data += written;
            left -= static_cast<std::size_t>(written);
            waited = 0;
        } else if (errno == EAGAIN) {
            wait_for_room(waited);
        } else if (errno != EINTR) {
            return close();
        }
    }
    fed_ |= left == 0;
}

void VideoPipe::wait_for_room(double& waited) {
    pollfd room{.fd = ffmpeg_->feed(), .events = POLLOUT, .revents = 0};
    const Stopwatch watch;
    poll(&room, 1, static_cast<int>(1000 * glance));
    if (use_ == Use::Live || signals_.arrived() != 0) waited += watch.seconds();
    if (waited > patience) give_up();
}

void VideoPipe::give_up() {
    ffmpeg_->kill();
    ffmpeg_.reset();
    error_ = "ffmpeg stood still and was ended";
}

void VideoPipe::end() {
    if (ffmpeg_) ffmpeg_->end_feed();
}

bool VideoPipe::finished(double seconds) {
    if (!ffmpeg_) return true;
    const std::optional<int> code = ffmpeg_->wait(seconds);
    if (!code) return false;
    ffmpeg_.reset();
    if (*code > 128 && *code <= 128 + SIGRTMAX) {
        error_ = "ffmpeg was ended by signal " + std::to_string(*code - 128);
    } else if (*code != 0) {
        error_ = "ffmpeg failed with status " + std::to_string(*code);
    } else if (std::error_code gone; fed_ && std::filesystem::file_size(file_.name(), gone) == 0) {
        error_ = "ffmpeg has written nothing";
    } else if (fed_) {
        name_file();
    }
    return true;
}

void VideoPipe::name_file() {
    try {
        if (use_ == Use::Live) {
            name_ = file_.finish_beside();
        } else {
            file_.finish();
        }
    } catch (const RunError& error) {
        error_ = error.what();
    }
}

void VideoPipe::close() {
    end();
    for (double waited = 0, after_signal = 0; !finished(glance);) {
        if (use_ == Use::Live) waited += glance;
        if (signals_.arrived() != 0) after_signal += glance;
        if (waited > end_patience_ || after_signal > patience) return give_up();
    }
}

}  // namespace drape
