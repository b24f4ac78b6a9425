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

/// To be called before there is a context: a drawing library that finds too little memory ends the whole program.
/// @param scene what a simulation takes on top [bytes]
/// @throws RunError that says what pictures need, where this machine, the process's control group or `ulimit -v` allows
///         less
void check_picture_memory(PictureSize size, double scene = 0);

}  // namespace drape
