#include "scene_watch.h"

#include <system_error>
#include <utility>

#include "drape/base/input_error.h"
#include "drape/scene/scene.h"

namespace drape {

void SceneWatch::watch(const std::string& scene) {
    try {
        if (file_ == scene_file(scene)) return;  // it may have been saved while it was read
        file_ = scene_file(scene);
    } catch (const InputError&) {
        file_.clear();  // that of a snapshot may be gone
    }
    known_ = last_ = look();
}

bool SceneWatch::saved(double elapsed) {
    constexpr double between_looks = 0.2;  // s
    since_look_ += elapsed;
    if (file_.empty() || since_look_ < between_looks) return false;
    since_look_ = 0;
    const std::optional<Look> now = look();
    if (!now) return false;
    const bool stands_still = std::exchange(last_, now) == now;
    if (!stands_still || now == known_) return false;
    known_ = now;
    return true;
}

std::optional<SceneWatch::Look> SceneWatch::look() const {
    std::error_code none;
    const auto time = std::filesystem::last_write_time(file_, none);
    if (none) return {};
    const std::uintmax_t size = std::filesystem::file_size(file_, none);
    if (none) return {};
    return Look{time, size};
}

}  // namespace drape
