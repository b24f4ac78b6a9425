#pragma once

#include <vector>

#include "method.h"
#include "motion.h"
#include "runner.h"

namespace drape::peers {

/// Times all methods on one motion. Every frame is checked against brute force.
/// @throws RunError if a method finds another set
std::vector<Result> race(const Motion& motion, int turns);

}  // namespace drape::peers
