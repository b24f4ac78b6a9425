#pragma once

#include <span>
#include <string>
#include <vector>

#include "drape/sim/simulation.h"

namespace drape {

/// How far apart two simulations are, and what there is to draw of the other one.
struct ComparisonView {
    FrameView other;                                ///< `blend`: where it is at the time of the first
    std::span<const std::vector<float>> distances;  ///< for each cloth, of each particle from its place there [m]
    double rms = 0, largest = 0;                    ///< of these [m]
    std::string_view assignments;                   ///< in which they differ: "solver.integrator=backward_euler"
};

/// A second simulation of a scene with other settings, which does what is done to the first one, and comes along in
/// time. Cloths are compared where their particles lie in the flat cloth, so that grids may differ.
class Comparison {
public:
    /// Begins the other one at its start, where the first has to be.
    /// @param assignments "name=value,name=value"; a part without "=" belongs to the value before it
    /// @throws InputError if they do not fit the scene, RunError if there is too little memory for both
    Comparison(const Simulation& first, std::string assignments);

    /// Does to the other simulation what has been done to the first, where it can; of settings, those that are not
    /// compared.
    /// @throws RunError if there is too little memory
    /// @pre the scene is still the same
    void apply(const Command& command, const Simulation& first);

    /// Makes the steps until it is no earlier than the first one, unless it has diverged.
    void follow(const Simulation& first);

    [[nodiscard]] ComparisonView view(const Simulation& first);

    [[nodiscard]] const Simulation& other() const { return other_; }

private:
    void follow_command(const Command& command, const Simulation& first);
    [[nodiscard]] bool compares(std::string_view setting) const;
    [[nodiscard]] static Simulation make_other(const Simulation& first, std::string_view assignments);

    std::string text_;
    Simulation other_;
    ScratchOnCopy<std::vector<std::vector<float>>> distances_;
};

/// "a=1,2,b=3" as "a=1,2" and "b=3".
/// @throws InputError if the first has no "="
std::vector<std::string> split_assignments(std::string_view text);

}  // namespace drape
