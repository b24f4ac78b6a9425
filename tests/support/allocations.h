#pragma once

namespace drape::testing {

/// Calls of malloc and its kin by this program so far.
long long allocations();

}  // namespace drape::testing
