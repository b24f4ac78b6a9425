#pragma once

#include <optional>
#include <string>
#include <vector>

#include "drape/base/command_line.h"
#include "drape/base/output_file.h"
#include "drape/scene/settings.h"
#include "drape/session/recording.h"
#include "drape/session/session.h"

namespace drape {

/// What all three programs are told on their command lines, of where a run starts and what is left of it.
struct StartOptions {
    std::string scene = {};                     ///< name or path; empty: that of the replay, else the first shipped one
    std::vector<std::string> assignments = {};  ///< "name=value"; a word without '=' is the scene if none was given
    std::string replay = {};                    ///< file; empty: none
    std::string load = {};                      ///< snapshot; empty: none
    std::string versus = {};  ///< what the scene is compared with, as `Comparison` has it; empty: nothing
    std::string save = {};    ///< file of a snapshot at the end; empty: none
    bool hash = false;        ///< print the hash of the last state

    /// Whether they say nothing of where to start.
    [[nodiscard]] bool empty() const {
        return scene.empty() && assignments.empty() && replay.empty() && load.empty() && versus.empty();
    }
};

/// Adds these to a command line, but for --versus.
/// @param options outlive the parsing
inline void add_start_options(CommandLine& line, StartOptions& options) {
    line.option("scene", options.scene, "name of a shipped scene, or a TOML file", {"SCENE"});
    line.option("--set", options.assignments, "change settings, as in --set dt=1e-4", {"name=value"});
    line.option("--replay", options.replay, "play a recording", {"FILE"});
    line.option("--load", options.load, "go on from a snapshot", {"FILE"});
    line.option("--save", options.save, "write a snapshot at the end, which --load goes on from", {"FILE"});
    line.flag("--hash", options.hash, "print the hash of the last state");
}

/// What a run starts from, found and checked before anything is opened or written.
struct Start {
    std::string scene;
    std::vector<std::string> assignments;  ///< of the recording and of the command line, in this order
    Settings settings;
    std::optional<Recording> replay;
    std::string load = {};  ///< snapshot that is gone on from; then the assignments are of the command line alone
    std::string versus = {};
};

/// @throws InputError if a file, a scene or an assignment is bad
Start make_start(StartOptions options);

/// `check_apart` of the files that a run is to write and those that its start was read from.
/// @throws InputError as it does
void check_written(const StartOptions& options, const Start& start, const std::vector<NamedFile>& written);

/// The simulation of a start, with its replay running.
/// @param record file for a recording of all that follows, the replay's commands included; empty: it is kept for
/// `Session::save_recording`; nothing: none is made
/// @throws InputError if `Start::versus` does not fit the scene
/// @throws RunError if the recording cannot be written, or memory is too little for a comparison
Session make_session(Start start, const std::optional<std::string>& record = {});

/// Writes the snapshot that a command line asks for at the end of a run, or says why there is none.
/// @param file empty: none is asked for
/// @throws RunError as `write_snapshot`
void save_snapshot(const std::string& file, Simulation& simulation);

}  // namespace drape
