#include "drape/base/resources.h"

#include <cstdlib>
#include <string>
#include <system_error>

#include "drape/base/input_error.h"

namespace drape {

std::filesystem::path program_folder() {
    std::error_code error;
    const auto program = std::filesystem::read_symlink("/proc/self/exe", error);
    if (error) throw RunError("cannot tell where the program is: " + error.message());
    return program.parent_path();
}

std::filesystem::path find_resource(const std::filesystem::path& name) {
    std::string tried;
    const auto found_in = [&](const std::filesystem::path& folder) {
        tried += (tried.empty() ? "" : " and ") + folder.string();
        std::error_code error;
        return std::filesystem::exists(folder / name, error);
    };
    if (const char* folder = std::getenv("DRAPE_DATA"); folder != nullptr && found_in(folder)) {
        return std::filesystem::path(folder) / name;
    }
    const auto share = (program_folder() / "../share/drape").lexically_normal();
    if (found_in(share)) return share / name;
    throw RunError("cannot find " + name.string() + " in " + tried);
}

}  // namespace drape
