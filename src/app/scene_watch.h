#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace drape {

/// Says when a scene's file has been saved by somebody else.
class SceneWatch {
public:
    /// Watches the file of a scene from now on, as it is now.
    void watch(const std::string& scene);

    /// Lets time pass, and looks at the file now and then: an editor may write it in several steps, so that it counts
    /// as saved only once it has been the same twice.
    /// @param elapsed [s]
    /// @return whether it has been saved since the last time it had been
    bool saved(double elapsed);

private:
    struct Look {
        std::filesystem::file_time_type time;
        std::uintmax_t size = 0;
        bool operator==(const Look&) const = default;
    };
    /// Nothing where there is no file, as between the two steps of a save by renaming.
    [[nodiscard]] std::optional<Look> look() const;

    std::filesystem::path file_;  ///< empty: none
    std::optional<Look> known_, last_;
    double since_look_ = 0;  ///< [s]
};

}  // namespace drape
