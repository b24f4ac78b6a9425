#include "drape/bounds/broad_phase.h"
#include "method.h"
#include "touching.h"

namespace drape::peers {

void Peer::query(const Points& x, const Ball& ball, std::vector<int>& touched) {
    touched.clear();
    list_candidates(grown(ball, 16 * epsilon() * (ball.centre.cwiseAbs().sum() + ball.radius)), touched);
    keep_touched(grid_, x, ball, touched);
}

}  // namespace drape::peers
