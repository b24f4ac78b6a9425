#pragma once

#include "capture_options.h"
#include "drape/base/stop_signals.h"

namespace drape {

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
