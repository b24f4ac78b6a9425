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
    std::error_code error;
    const auto failed = [&] { return RunError(file.string() + ": cannot be written: " + error.message()); };
    const files::path target = files::weakly_canonical(file, error);
    if (error) throw failed();
    const files::path unfinished = target.string() + ".unfinished";
    OutputFile out(unfinished.string());
    out.stream() << scene_text(written);
    out.close();
    if (files::exists(target, error)) {
        files::copy_file(target, target.string() + "~", files::copy_options::overwrite_existing, error);
        if (!error) files::permissions(unfinished, files::status(target).permissions(), error);
    }
    if (!error) files::rename(unfinished, target, error);
    if (!error) return;
    std::error_code ignored;
    files::remove(unfinished, ignored);
    throw failed();
}

}  // namespace drape
