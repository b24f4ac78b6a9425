#include "drape/sim/rest_watch.h"

#include "drape/bounds/leaf_copies.h"

namespace drape {

bool RestWatch::look(const Points& x, double time, Real reach) {
    if (!watching_ || largest_displacement(x, places_) > reach) {
        watching_ = true;
        since_ = time;
        places_ = x;
    }
    return time - since_ >= duration;
}

}  // namespace drape
