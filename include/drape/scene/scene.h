#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "drape/scene/settings.h"

namespace drape {

/// Reads a scene by the name of a shipped one ("drop") or by the path of a TOML file.
/// @throws InputError as `file:line:column: name = value: allowed ...`; an unknown key names the nearest known one
Settings load_scene(const std::string& name_or_path);

/// The file that `load_scene` reads.
/// @throws InputError if it is no path and no shipped scene's name
std::filesystem::path scene_file(const std::string& name_or_path);

/// Reads a scene from text; `file` names it in errors.
/// @throws InputError
Settings parse_scene(std::string_view text, const std::string& file);

/// The scene file of some settings: all that differ from their defaults, and the sizes of the cloths.
/// `parse_scene` reads the same settings back.
std::string scene_text(const Settings& settings);

/// The "name=value" of every setting that is not as in a scene.
/// @param scene as it was loaded
/// @throws RunError if no such assignments make these settings of the scene's: moving pins have ended
std::vector<std::string> changes_of(const Settings& scene, const Settings& settings);

/// The names of the shipped scenes in the order of the keys 1-9: `veil` and `drop` first, the rest by name, and those
/// that are made to fail (`fails_...`) last.
std::vector<std::string> scene_names();

}  // namespace drape
