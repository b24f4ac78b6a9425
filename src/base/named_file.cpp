#include "drape/base/named_file.h"

#include "drape/base/input_error.h"
#include "drape/base/unfinished_file.h"

namespace drape {
namespace {

namespace files = std::filesystem;

bool is_device(const files::path& file) {
    std::error_code ignored;
    return files::exists(file, ignored) && !files::is_regular_file(file, ignored);
}

bool are_one(const files::path& one, const files::path& other) {
    if (is_device(one) || is_device(other)) return false;
    std::error_code missing;
    return files::equivalent(one, other, missing) || link_target(one) == link_target(other);
}

}  // namespace

void check_apart(const std::vector<NamedFile>& files) {
    for (auto file = files.begin(); file != files.end(); ++file) {
        for (auto other = files.begin(); other != file; ++other) {
            const bool written = file->use == NamedFile::Use::Write || other->use == NamedFile::Use::Write;
            if (!written || file->path.empty() || other->path.empty() || !are_one(file->path, other->path)) continue;
            const std::string first = file->path == other->path ? "" : " " + other->path.string();
            throw InputError(other->option + first + " and " + file->option + " " + file->path.string() +
                             (first.empty() ? "" : ", the same file") + ": allowed two different files");
        }
    }
}

}  // namespace drape
