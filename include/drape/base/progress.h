#pragma once

#include <filesystem>
#include <string>

#include "drape/base/stopwatch.h"

namespace drape {

/// Tells on standard error how far a long run has come and how long it will take: on a terminal in one line that
/// changes, elsewhere in a new line now and then.
class Progress {
public:
    /// @param total of the things to do
    /// @param noun of one: "picture"
    Progress(std::size_t total, std::string noun);
    ~Progress() { clear(); }  ///< what is said of a failure starts on an empty line
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// Another one is done.
    void advance();

    /// Says how many there are, and where.
    void close(const std::filesystem::path& folder);

    /// Makes room on a terminal for something else to be said.
    void clear();

private:
    Stopwatch watch_;
    std::size_t total_, done_ = 0;
    std::string noun_;
    double told_ = 0;  ///< when it was last told [s]
    bool terminal_;
    bool shown_ = false;  ///< a line that is to be rewritten
};

}  // namespace drape
