#pragma once

#include <string>

namespace drape {

/// The commit that the program was built from, with a hash of what was changed since; "unknown" outside of a clone.
std::string commit();

}  // namespace drape
