#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "drape/base/output_file.h"
#include "drape/sim/command.h"

namespace drape {

/// A line of a recording: a command, or the hash that the state had, before step number `step`.
struct RecordedEntry {
    std::int64_t step = 0;
    std::variant<Command, std::uint64_t> content;
    int line = 0;  ///< of the file
};

/// A recording as read from a file. Its text: a first line `drape-recording 1`, a line `scene NAME`, a line `set
/// name=value` for each setting given at the start, then `STEP COMMAND` or `STEP hash HEX` a line, and a last line
/// `STEP end`.
struct Recording {
    static constexpr int first_assignment = 3;  ///< its line; the others follow

    std::string scene;
    std::vector<std::string> assignments;
    std::vector<RecordedEntry> entries;
    std::optional<std::int64_t> last_step;  ///< where it was closed; nothing if it never was
    std::string notice;     ///< why it was cut short: truncated, or a line that is no command; empty if whole
    std::string file = {};  ///< for messages
};

/// @throws InputError if the file cannot be read or is no recording; a damaged tail is cut and said in `notice`
Recording read_recording(const std::string& file);

/// The same from a stream; `file` names it in messages.
Recording read_recording(std::istream& in, const std::string& file);

/// Puts commands before it that load its scene with its settings: for a session that has another one.
/// @throws InputError if they cannot be set one after the other
void load_scene_first(Recording& recording);

/// The names of the files in a folder that begin as recordings do, in their order. What cannot be read is none.
/// @par Cost opens every file there
std::vector<std::string> recordings_in(const std::filesystem::path& folder);

/// Writes a recording line by line, so that a crash loses at most the last one. Until it is closed it is named
/// "FILE.unfinished". Without a file the text is kept until it is saved, and begins again with each scene.
class Recorder {
public:
    /// @param file empty: none
    /// @throws RunError if the file cannot be created, or another run is recording into it
    Recorder(const std::string& file, const std::string& scene, const std::vector<std::string>& assignments);

    void write(std::int64_t step, const Command& command);
    void write_hash(std::int64_t step, std::uint64_t hash);

    /// A step is made. If a replay of what was written would stand still here, it is written that it goes on.
    void begin_step(std::int64_t step);

    /// Takes back all that was written of later steps.
    /// @return false if this file cannot be cut: all is as it was
    /// @throws RunError if not everything could be written
    bool cut_after(std::int64_t step);

    /// Writes what there is so far as a recording of its own, which ends at this step.
    /// @return false if a file has that name: it stays
    /// @throws RunError if not everything could be written
    [[nodiscard]] bool save(const std::filesystem::path& file, std::int64_t step) const;

    /// @throws RunError if not everything could be written
    void close(std::int64_t step);

    [[nodiscard]] bool has_file() const { return file_.wanted(); }

    /// Where the recording of a killed run has gone that was not closed; empty if there was none.
    [[nodiscard]] std::filesystem::path set_aside() const { return file_.set_aside(); }

private:
    /// Where a line begins in the text.
    struct Line {
        std::int64_t step;
        std::size_t begin;
        bool paused;  ///< before it
    };

    void begin(const std::string& scene, const std::vector<std::string>& assignments);
    void add(std::int64_t step, const std::string& what);

    OutputFile file_;
    std::string text_;  ///< that the file has, too
    std::vector<Line> lines_;
    std::int64_t first_step_ = 0;
    bool paused_ = false;       ///< a replay is, at this point
    std::int64_t granted_ = 0;  ///< steps that it makes all the same
};

}  // namespace drape
