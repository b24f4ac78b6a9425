#pragma once

#include <filesystem>

namespace drape {

/// The folder of the running program.
/// @throws RunError if the system does not tell.
std::filesystem::path program_folder();

/// A shipped file such as "scenes/drop.toml" or "shaders/cloth.vert".
/// Looked for in `$DRAPE_DATA` if set, else in `../share/drape` beside the folder of the running program, which is
/// where the build tree and an installed tree both keep it.
/// @throws RunError naming the folders that were looked in.
std::filesystem::path find_resource(const std::filesystem::path& name);

}  // namespace drape
