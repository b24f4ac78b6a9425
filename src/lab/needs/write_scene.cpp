#include "write_scene.h"

#include "drape/base/output_file.h"
#include "drape/sim/scene_text.h"

namespace drape {

Settings with_full_model(Settings found, const Settings& full) {
    const ClothParameters& cloth = full.cloths[0];
    found.needs.full = {cloth.particles, cloth.bend, cloth.drag};
    return found;
}

std::filesystem::path file_of_scene(const std::string& name_or_path) {
    const bool is_path = name_or_path.find('/') != std::string::npos || name_or_path.ends_with(".toml");
    return is_path ? name_or_path : name_or_path + ".toml";
}

void write_scene(const Settings& scene, const std::filesystem::path& file) {
    Settings written = scene;
    // A scene names its start state as seen from its own folder
    if (!written.start.empty()) {
        const auto folder = std::filesystem::absolute(file).parent_path();
        written.start = std::filesystem::absolute(written.start).lexically_relative(folder).string();
    }
    const std::filesystem::path unfinished = file.string() + ".unfinished";
    OutputFile out(unfinished.string());
    out.stream() << scene_text(written);
    out.close();
    std::error_code error;
    std::filesystem::rename(unfinished, file, error);
    if (error) throw RunError(file.string() + ": cannot be written: " + error.message());
}

}  // namespace drape
