#include "program.h"

#include <algorithm>

namespace drape::test {

namespace {

std::string path_of(const std::string& name) { return std::string(DRAPE_PROGRAMS) + "/" + name; }

}  // namespace

Words TestFolder::names(const std::string& folder) const {
    Words all;
    for (const auto& entry : std::filesystem::directory_iterator(path() / folder)) {
        all.push_back(entry.path().filename().string());
    }
    std::ranges::sort(all);
    return all;
}

Words joined(Words words, const Words& more) {
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

Running::Running(const TestFolder& folder, const Words& words)
    : Process(joined({path_of("drape-capture")}, words), {{"PATH", folder / "" + ":/bin:/usr/bin"}}, folder.path()) {}

Outcome run_program(const std::string& name, const Words& arguments,
                    const std::map<std::string, std::string>& environment) {
    const TestFolder folder;
    Process process(joined({path_of(name)}, arguments), environment, folder.path());
    const int code = process.wait_to_end();
    return {code, process.standard_output(), process.standard_error()};
}

}  // namespace drape::test
