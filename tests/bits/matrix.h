#pragma once

#include <map>
#include <string>
#include <vector>

#include "lab/lab_run.h"

namespace drape::test {

using Words = std::vector<std::string>;

/// A way to run the laboratory that must not change a bit.
struct Way {
    std::string name;
    Words before = {};  ///< words in front of the program's own
    std::map<std::string, std::string> environment = {};
    std::string lab = DRAPE_LAB;
};

/// A small cloth that meets the ball in the wind within a few steps; settings may follow.
extern const std::string small_case;

/// Hash and exit code of a program's run; "no hash" and why, if it printed none.
std::string bits_of(const LabFolder& folder, const Way& way, const std::string& program, const Words& arguments);

/// Runs of a scene, each with its bits when it is run plainly.
class Matrix {
public:
    /// @param command_line what follows `drape-lab simulate`
    void add(const std::string& command_line);

    /// The small case with every method, or with some; and a cloth for multigrid.
    void add_methods();
    void add_methods(const Words& methods);

    /// A cloth large enough for four threads, with the methods that share their work.
    void add_threaded();

    /// The small case with every volume, under a limited search: then nodes stand for the cloth, and its motion shows
    /// every bit that the volumes' kernels find.
    void add_volumes();

    /// Every shipped scene, each for a moment.
    /// @param methods names, or "" for the scene's own
    void add_scenes(const Words& methods);

    /// Runs all of it once more and expects the same bits.
    /// @param more words at the end of each command line
    /// @return the number of comparisons
    [[nodiscard]] int compare(const Way& way, const Words& more = {}) const;

private:
    LabFolder folder_;
    std::vector<Words> cells_;
    std::vector<std::string> plain_;
};

/// Says how many comparisons a test has made, to the reader and to the table of results.
void tell_comparisons(int count);

/// Why the emulator cannot be used, empty if it can: it is missing, or the programs carry sanitizers, which it cannot
/// run.
std::string no_emulator();

/// True if the shell finds a program of this name.
bool can_run(const std::string& program);

}  // namespace drape::test
