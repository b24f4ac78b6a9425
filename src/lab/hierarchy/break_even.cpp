#include "break_even.h"

#include "drape/base/assert.h"

namespace drape {

std::optional<std::size_t> break_even_frame(std::span<const double> costs, std::span<const double> others) {
    DRAPE_ASSERT(costs.size() == others.size());
    std::optional<std::size_t> since;
    double lead = 0;
    for (std::size_t k = 0; k < costs.size(); ++k) {
        lead += others[k] - costs[k];
        if (!(lead < 0)) {
            since.reset();
        } else if (!since) {
            since = k;
        }
    }
    return since;
}

}  // namespace drape
