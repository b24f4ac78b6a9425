#pragma once

#include <vector>

#include "bench/cut_sheet.h"

namespace drape::peers {

/// One frame of the motion.
struct Frame {
    Points x;
    Ball ball;
    std::vector<int> touched;  ///< by brute force, ascending
};

/// A sheet of side 1 on which waves travel, every particle on its own orbit, and a ball on a closed path that cuts
/// about a tenth of it out. After the last frame comes the first.
struct Motion {
    Grid grid;
    std::vector<Frame> frames;

    Motion(int side, int count);
};

}  // namespace drape::peers
