#include "force_scratch.h"

#include "drape/model/stencils.h"

namespace drape::kernels {

void lay_out(const Grid& grid, const Part& part, const Scratch& scratch) {
    scratch.clear();
    const Strip strip(part, grid);
    for (std::size_t s = 0; s < spring_directions.size(); ++s) {
        const int di = spring_directions[s].di;
        const int first = std::max(strip.first, -di), last = std::min(strip.end, strip.grid.nx - di);
        if (first < last) std::fill_n(scratch.there(static_cast<int>(s)) + strip.at(first), last - first, Real(1));
    }
}

}  // namespace drape::kernels
