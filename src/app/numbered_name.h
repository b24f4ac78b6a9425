#pragma once

#include <filesystem>
#include <string>

namespace drape {

/// "drape-0007.png": how the window calls what it writes.
std::filesystem::path numbered_name(int number, const std::string& extension);

}  // namespace drape
