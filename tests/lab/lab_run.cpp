#include "lab/lab_run.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

namespace drape::test {

LabRun LabFolder::run(const std::vector<std::string>& words, const std::string& program,
                      const std::map<std::string, std::string>& environment) const {
    std::vector<std::string> all{program};
    all.insert(all.end(), words.begin(), words.end());
    std::map<std::string, std::string> changes = environment;
    changes.emplace("DRAPE_DATA", "");
    Process process(all, changes, path());
    const int code = process.wait(600).value_or(-1);
    return {code, process.standard_output(), process.standard_error()};
}

std::string LabFolder::write(const std::string& name, const std::string& text) const {
    std::ofstream(path() / name, std::ios::binary) << text;
    return name;
}

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

std::vector<std::string> table_of(const LabFolder& folder, const std::string& file) {
    std::vector<std::string> lines = lines_of(folder.read(file));
    std::erase_if(lines, [](const std::string& line) { return line.starts_with('#'); });
    return lines;
}

}  // namespace drape::test
