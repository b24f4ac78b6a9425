#include "window_size.h"

#include <sys/stat.h>

#include <algorithm>
#include <cstdlib>

#include "drape/base/input_error.h"
#include "drape/base/input_file.h"
#include "drape/base/output_file.h"

namespace drape {

namespace {

constexpr int most_side = 8192;  // that `parse_size` allows

PictureSize within(const PictureSize& size, const PictureSize& most) {
    constexpr int least_width = 320, least_height = 180;
    return {std::clamp(size.width, least_width, std::max(most.width, least_width)),
            std::clamp(size.height, least_height, std::max(most.height, least_height))};
}

}  // namespace

std::filesystem::path window_size_file() {
    const auto folder = [](const char* variable) {
        const char* const value = std::getenv(variable);
        const std::filesystem::path path = value == nullptr ? "" : value;
        return path.is_absolute() ? path : std::filesystem::path();  // as the XDG Base Directory Specification says
    };
    const std::filesystem::path state = folder("XDG_STATE_HOME"), home = folder("HOME");
    if (!state.empty()) return state / "drape/window";
    return home.empty() ? home : home / ".local/state/drape/window";
}

std::optional<PictureSize> kept_window_size(const PictureSize& screen) {
    constexpr int longest_text = 16;
    const std::filesystem::path file = window_size_file();
    if (file.empty()) return std::nullopt;
    try {
        std::string text = read_text(file, longest_text, InputKind::Regular);
        if (text.ends_with('\n')) text.pop_back();
        return within(parse_size(text), screen);
    } catch (const InputError&) {
        return std::nullopt;
    }
}

void keep_window_size(const PictureSize& size) {
    const std::filesystem::path file = window_size_file();
    if (file.empty()) return;
    std::error_code refused;
    const mode_t mask = umask(0077);  // the specification wants new folders to be the user's alone
    std::filesystem::create_directories(file.parent_path(), refused);
    umask(mask);
    try {
        OutputFile out(file);
        out.stream() << size_text(within(size, {most_side, most_side})) << "\n";
        out.close();
    } catch (const RunError&) {
        return;
    }
}

}  // namespace drape
