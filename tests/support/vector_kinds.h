#pragma once

#include <hwy/targets.h>

#include <cstdint>

namespace drape::test {

/// Calls test(name) with each kind of vector of this processor alone.
/// @return how many kinds there are
template <class Test>
int with_every_kind_of_vector(Test test) {
    int kinds = 0;
    for (std::int64_t targets = hwy::SupportedTargets(); targets != 0; targets &= targets - 1, ++kinds) {
        hwy::SetSupportedTargetsForTest(targets & -targets);
        test(hwy::TargetName(targets & -targets));
        hwy::SetSupportedTargetsForTest(0);
    }
    return kinds;
}

}  // namespace drape::test
