#pragma once

namespace drape::test {

/// Calls of malloc and its kin by this program so far.
long long allocations();

/// Memory that this program has taken and not given back [bytes].
long long bytes_held();

/// The most of it at any time since the program began, or since the last call of `forget_most_bytes_held` [bytes].
long long most_bytes_held();
void forget_most_bytes_held();

}  // namespace drape::test
