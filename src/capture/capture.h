#pragma once

#include <optional>
#include <string>

#include "drape/base/stop_signals.h"
#include "drape/render/image.h"
#include "drape/session/start.h"
#include "gl_context.h"

namespace drape {

/// What the command line of `drape-capture` asks for.
struct CaptureOptions {
    StartOptions start;
    int frames = 0;
    std::optional<double> fps;  ///< frames per simulated second; none: 60 in a second of a window
    int every = 1;              ///< only each so many-th frame is drawn
    PictureSize size;
    std::string out;     ///< folder of the pictures; empty: none
    std::string video;   ///< file; empty: none
    std::string stats;   ///< file; empty: none
    std::string state;   ///< file; empty: none
    bool again = false;  ///< the folder's frames of an earlier run are replaced
    bool overlay = false;
    bool tour = false;  ///< a picture of each stop of the tour, and nothing else
    ContextKind context = ContextKind::Auto;

    /// Whether anything that is asked for needs pictures.
    [[nodiscard]] bool drawing() const { return !out.empty() || !video.empty() || !stats.empty(); }
};

/// @return nothing if the command line asked for text, which was printed
/// @throws InputError
std::optional<CaptureOptions> read_capture_options(int argc, char** argv);

/// Simulates a scene, draws it and writes what is asked for. All that it writes is opened, and tried, before it
/// simulates; signals end it between two steps.
/// @return the exit code
/// @throws InputError; RunError if a file could not be written
int capture(CaptureOptions options, const StopSignals& signals);

/// Draws a picture of each stop of the tour at the time that it names, into `options.out`.
/// @return exit code
/// @throws RunError if a picture could not be written
int draw_tour(const CaptureOptions& options, const StopSignals& signals);

}  // namespace drape
