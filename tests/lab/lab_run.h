#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "support/process.h"
#include "support/scratch_file.h"

namespace drape::test {

/// What a finished run of a laboratory program said.
struct LabRun {
    int code = -1;  ///< exit code; 256 + signal if it was killed
    std::string out, err;

    /// Whether it found no gnuplot to draw its charts.
    [[nodiscard]] bool has_no_gnuplot() const { return err.find("no gnuplot") != std::string::npos; }
};

/// A folder for one test's files, gone with the object; `drape-lab` runs in it.
class LabFolder : public ScratchFolder {
public:
    using ScratchFolder::path;

    /// Runs `drape-lab` with these words to its end.
    [[nodiscard]] LabRun run(const std::vector<std::string>& words, const std::string& program = DRAPE_LAB,
                             const std::map<std::string, std::string>& environment = {}) const;

    /// @return the name of the file that was written
    std::string write(const std::string& name, const std::string& text) const;
    [[nodiscard]] std::filesystem::path path(const std::string& name) const { return path() / name; }
    [[nodiscard]] std::string read(const std::string& name) const { return read_file(path() / name); }
    [[nodiscard]] bool has(const std::string& name) const { return std::filesystem::exists(path() / name); }
};

/// The lines of a text, without their ends.
std::vector<std::string> lines_of(const std::string& text);

/// The values of one row of a CSV file.
std::vector<double> values_of(const std::string& row);

/// A text with one part of it replaced, which must be there.
std::string replaced(std::string text, const std::string& from, const std::string& to);

/// The lines of an experiment's table without its head.
std::vector<std::string> table_of(const LabFolder& folder, const std::string& file);

}  // namespace drape::test
