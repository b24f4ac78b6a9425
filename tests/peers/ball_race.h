#pragma once

#include <array>
#include <limits>
#include <string>
#include <vector>

#include "drape/model/ball.h"
#include "drape/model/grid.h"
#include "runner.h"

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
    std::vector<std::array<int, 3>> corners;  ///< of each triangle
    std::vector<Frame> frames;

    Motion(int side, int count);
};

/// A way to find the triangles of a moving cloth whose distance to the ball's centre is at most its radius.
class BallMethod : public Runner {
protected:
    /// @param motion outlives the method, which starts at its last frame
    BallMethod(std::string name, const Motion& motion);

    const Motion& motion_;
    Points x_;
    Ball ball_;
    std::vector<int> touched_;  ///< what `query` finds, in any order

private:
    void prepare(std::size_t frame) final;
    int check(std::size_t frame) final;
};

/// A library that finds candidates, which are then decided one by one.
class BallPeer : public BallMethod {
protected:
    /// @param epsilon the rounding of one number in the library, as a share of it
    BallPeer(std::string name, const Motion& motion, Real epsilon = std::numeric_limits<Real>::epsilon())
        : BallMethod(std::move(name), motion), epsilon_(epsilon) {}

    /// @param ball grown by what a bound or a position may be off
    /// @param triangles receives every triangle that touches it, each once, and perhaps more; empty before
    virtual void list_candidates(const Ball& ball, std::vector<int>& triangles) = 0;

private:
    void query() final;

    Real epsilon_;
};

/// Drape's own: brute force first, which is no tree, then the trees.
void add_ours(Runners& runners, const Motion& motion);
void add_fcl(Runners& runners, const Motion& motion);
void add_bullet(Runners& runners, const Motion& motion);
void add_embree(Runners& runners, const Motion& motion);

}  // namespace drape::peers
