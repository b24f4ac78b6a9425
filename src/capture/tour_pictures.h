#pragma once

#include "capture_options.h"
#include "drape/base/stop_signals.h"

namespace drape {

/// Draws a picture of each stop of the tour at the time that it names, into `options.out`.
/// @return exit code
/// @throws RunError if a picture could not be written
int draw_tour(const CaptureOptions& options, const StopSignals& signals);

}  // namespace drape
