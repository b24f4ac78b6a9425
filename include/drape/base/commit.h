#pragma once

#include <string>

namespace drape {

/// The commit that the program was built from, with a hash of what was changed since; "unknown" outside of a clone.
std::string commit();

/// The libraries that it was built from: "Eigen 3.4.0, Highway 1.0.3, ...".
std::string libraries();

}  // namespace drape
