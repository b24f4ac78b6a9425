#include "write_scene.h"

#include "drape/base/input_error.h"
#include "drape/base/output_file.h"
#include "drape/sim/scene_text.h"

namespace drape {

namespace files = std::filesystem;

Settings with_full_model(Settings found, const Settings& full) {
    const ClothParameters& cloth = full.cloths[0];
    found.needs.full = {cloth.particles, cloth.bend, cloth.drag};
    return found;
}

std::filesystem::path file_of_scene(const std::string& name_or_path) {
    const bool is_path = name_or_path.find('/') != std::string::npos || name_or_path.ends_with(".toml");
    if (is_path) return name_or_path;
    const std::string file = name_or_path + ".toml";
    std::error_code ignored;
    if (files::exists(files::symlink_status(file, ignored))) {
        throw InputError("--write: " + file + " is there already, and may be another scene: allowed ./" + file +
                         ", to read and write that one, or another folder");
    }
    return file;
}

void write_scene(const Settings& scene, const std::filesystem::path& file) {
    Settings written = scene;
    // A scene names its start state as seen from its own folder
    if (!written.start.empty()) {
        const auto folder = files::absolute(file).parent_path();
        written.start = files::absolute(written.start).lexically_relative(folder).string();
    }
    OutputFile out(file.string());
    out.stream() << scene_text(written);
    const files::path target = link_target(file);
    if (files::exists(target)) {
        const files::path kept = target.string() + "~";
        UnfinishedFile copy(kept);
        std::error_code error;
        files::copy_file(target, copy.name(), files::copy_options::overwrite_existing, error);
        if (!error) files::permissions(copy.name(), files::status(target).permissions(), error);
        if (error) throw RunError(kept.string() + ": cannot be written: " + error.message());
        copy.finish();
    }
    out.close();
}

}  // namespace drape
