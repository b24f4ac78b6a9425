#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

#include "drape/base/input_error.h"
#include "drape/scene/scene.h"

namespace drape {

/// Says when a scene's file has been saved by somebody else.
class SceneWatch {
public:
    /// Watches the file of a scene from now on, as it is now.
    void watch(const std::string& scene) {
        try {
            if (file_ == scene_file(scene)) return;  // it may have been saved while it was read
            file_ = scene_file(scene);
        } catch (const InputError&) {
            file_.clear();  // that of a snapshot may be gone
        }
        known_ = last_ = look();
    }

    /// Lets time pass, and looks at the file now and then: an editor may write it in several steps, so that it counts
    /// as saved only once it has been the same twice.
    /// @param elapsed [s]
    /// @return whether it has been saved since the last time it had been
    bool saved(double elapsed) {
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

private:
    /// When the file was written last.
    using Look = std::filesystem::file_time_type;

    /// Nothing where there is no file, as between the two steps of a save by renaming.
    [[nodiscard]] std::optional<Look> look() const {
        std::error_code none;
        const auto time = std::filesystem::last_write_time(file_, none);
        if (none) return {};
        return time;
    }

    std::filesystem::path file_;  ///< empty: none
    std::optional<Look> known_, last_;
    double since_look_ = 0;  ///< [s]
};

}  // namespace drape
