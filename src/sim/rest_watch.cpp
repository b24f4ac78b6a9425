#include "drape/sim/rest_watch.h"

#include "drape/bounds/leaf_copies.h"

namespace drape {

bool RestWatch::look(const Points& x, double time, Real distance) {
    if (!watching_ || largest_displacement(x, start_) > distance) {
        watching_ = true;
        since_ = time;
        start_ = x;
    }
    return time - since_ >= duration;
}

}  // namespace drape
