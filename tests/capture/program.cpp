#include "program.h"

#include <filesystem>
#include <fstream>

namespace drape::test {

Words joined(Words words, const Words& more) {
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

Running::Running(const TestFolder& folder, const Words& words)
    : Process(joined({DRAPE_PROGRAMS "/drape-capture"}, words), path_from(folder), folder.path()) {}

std::map<std::string, std::string> path_from(const TestFolder& folder) {
    return {{"PATH", folder / "" + ":/bin:/usr/bin"}};
}

void put_ffmpeg(const TestFolder& folder, const std::string& script) {
    std::ofstream(folder / "ffmpeg") << "#!/bin/sh\n" << script;
    std::filesystem::permissions(folder / "ffmpeg", std::filesystem::perms::owner_all);
}

Outcome run_program(const std::string& name, const Words& arguments,
                    const std::map<std::string, std::string>& environment) {
    const TestFolder folder;
    Process process(joined({DRAPE_PROGRAMS "/" + name}, arguments), environment, folder.path());
    const int code = process.wait_to_end();
    return {code, process.standard_output(), process.standard_error()};
}

}  // namespace drape::test
