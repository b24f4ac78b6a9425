#pragma once

#include <string>

#include "options.h"

namespace drape {

/// Says in one line why there is no window, and becomes `drape-capture` of the same scene.
/// @throws RunError if that program is not beside this one
[[noreturn]] void capture_instead(const Options& options, const std::string& reason);

}  // namespace drape
