#pragma once

#include <optional>
#include <string>
#include <vector>

#include "drape/base/output_file.h"
#include "drape/sim/recording.h"
#include "drape/sim/session.h"
#include "drape/sim/settings.h"

namespace drape {

/// What all three programs are told on their command lines.
struct StartOptions {
    std::string scene;                     ///< name or path; empty: that of the replay, else the first shipped one
    std::vector<std::string> assignments;  ///< "name=value"; a word without '=' is the scene if none was given
    std::string replay;                    ///< file; empty: none
    std::string versus = {};               ///< what the scene is compared with, as `Comparison` has it; empty: nothing
};

/// What a run starts from, found and checked before anything is opened or written.
struct Start {
    std::string scene;
    std::vector<std::string> assignments;  ///< of the recording and of the command line, in this order
    Settings settings;
    std::optional<Recording> replay;
    std::string versus = {};
};

/// @throws InputError if a file, a scene or an assignment is bad
Start make_start(StartOptions options);

/// The files that a start was read from, to be kept apart from those that are written.
std::vector<NamedFile> input_files(const StartOptions& options, const Start& start);

/// The simulation of a start, with its replay running.
/// @param record file for a recording of all that follows, the replay's commands included; empty: none
/// @throws InputError if `Start::versus` does not fit the scene
/// @throws RunError if the recording cannot be written, or memory is too little for a comparison
Session make_session(Start start, const std::string& record = {});

}  // namespace drape
