#pragma once

#include <filesystem>
#include <string>

#include "drape/sim/settings.h"

namespace drape {

/// What is written of a configuration that was found: it, with the full model said in `needs.full`, so that it can be
/// found again.
Settings with_full_model(Settings found, const Settings& full);

/// The file in which a scene is written back: its own, or NAME.toml in the current folder if it is a shipped one's
/// name.
/// @throws InputError if a shipped one's name is that of a file in the current folder, which is another scene
std::filesystem::path file_of_scene(const std::string& name_or_path);

/// Writes a scene file whole or not at all: under another name, which then becomes its own. A file that was there stays
/// as NAME.toml~, and hands on its permissions; through a link, the file that it leads to is written.
/// @throws RunError if it cannot be written
void write_scene(const Settings& scene, const std::filesystem::path& file);

}  // namespace drape
