#include "lab/lab_run.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "drape/base/numbers.h"

namespace drape::test {

LabRun LabFolder::run(const std::vector<std::string>& words, const std::string& program,
                      const std::map<std::string, std::string>& environment) const {
    std::vector<std::string> all{program};
    all.insert(all.end(), words.begin(), words.end());
    std::map<std::string, std::string> changes = environment;
    changes.emplace("DRAPE_DATA", "");
    Process process(all, changes, path());
    const int code = process.wait_to_end();
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

std::vector<double> values_of(const std::string& row) {
    std::vector<double> values;
    for (const std::string_view cell : split_at_commas(row)) values.push_back(parse_real(cell).value());
    return values;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

std::vector<std::string> table_of(const LabFolder& folder, const std::string& file) {
    std::vector<std::string> lines = lines_of(folder.read(file));
    std::erase_if(lines, [](const std::string& line) { return line.starts_with('#'); });
    return lines;
}

}  // namespace drape::test
