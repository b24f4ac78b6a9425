#include "window_size.h"

#include <algorithm>
#include <cstdlib>

#include "drape/base/input_error.h"
#include "drape/base/input_file.h"
#include "drape/base/output_file.h"

namespace drape {

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
    constexpr int longest_text = 16, min_width = 320, min_height = 180;
    const std::filesystem::path file = window_size_file();
    if (file.empty()) return std::nullopt;
    try {
        std::string text = read_text(file, longest_text, InputKind::Regular);
        if (text.ends_with('\n')) text.pop_back();
        const PictureSize size = parse_size(text);
        return PictureSize{std::clamp(size.width, min_width, std::max(screen.width, min_width)),
                           std::clamp(size.height, min_height, std::max(screen.height, min_height))};
    } catch (const InputError&) {
        return std::nullopt;
    }
}

void keep_window_size(const PictureSize& size) {
    const std::filesystem::path file = window_size_file();
    if (file.empty()) return;
    std::error_code refused;
    std::filesystem::create_directories(file.parent_path(), refused);
    try {
        OutputFile out(file);
        out.stream() << size_text(size) << "\n";
        out.close();
    } catch (const RunError&) {
        return;
    }
}

}  // namespace drape
