#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "drape/integrate/stability.h"
#include "drape/sim/simulation.h"

namespace drape {

/// The vibration for which the step of a run that has diverged was too long.
struct UnstableMode {
    std::size_t cloth = 0;
    StepLimit limit = {};
    double step = 0;                 ///< that the run had [s]
    double time = 0;                 ///< of the calm moment at which the shape was found [s]
    Points shape = {};               ///< n x 3 displacements, of which the largest is 1; exactly 0 at pins
    std::array<int, 2> spring = {};  ///< ends of the spring that takes the largest part in it
    std::string_view kind = {};      ///< of that spring: "structural", "shear" or "bend"
};

/// Finds it.
/// @param before the same cloths at a moment before anything grew
/// @return nothing where the step was no longer than the limit at that moment, or the method has none
/// @par Cost that of `limiting_mode` for each cloth
std::optional<UnstableMode> find_unstable_mode(const Simulation& diverged, const Simulation& before);

/// The legend: what swings and which spring is marked.
/// @param with_limit limit and step in ms too: where the run's own message does not have them
std::string text_of(const UnstableMode& mode, bool with_limit);

/// Whether within a step no two ends of a spring move against each other by more than a twentieth of its length at
/// rest: a mode that grows shows there long before it shows in the cloth's shape.
/// @par Cost one pass over the springs
bool is_calm(const Simulation& simulation);

/// A run that has diverged, shown as it was at a moment before, swinging in its unstable mode.
class Swing {
public:
    static constexpr double frequency = 1;         ///< of wall time [Hz]
    static constexpr Real amplitude = Real(0.25);  ///< of the smaller side of a cell

    Swing(UnstableMode mode, Simulation before) : mode_(std::move(mode)), before_(std::move(before)) {}

    /// Lets wall time pass [s].
    void pass(double seconds) { time_ += seconds; }

    /// Puts cloths and bodies of that moment into a view of the run, and the mode.
    void show(FrameView& view);

private:
    UnstableMode mode_;
    Simulation before_;
    double time_ = 0;  ///< [s]
    Points x_;         ///< of the cloth that swings
    std::vector<ClothView> cloths_;
};

}  // namespace drape
