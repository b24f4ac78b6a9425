#pragma once

#include "lab/experiment/experiment.h"

namespace drape {

/// A trial: one method with one step on one sheet.
struct StabilityRow {
    std::string method, sweep;             ///< what varies: stiffness, damping, or damped_stiffness
    double side = 0;                       ///< particles along each
    double stiffness = 0, damping = 0;     ///< of every spring [N/m, N s/m]
    double omega = 0, zeta = 0;            ///< of the mode that sets the limit [1/s, 1]
    double predicted = 0;                  ///< linear limit [s]; infinite if there is none
    double expected = 0;                   ///< where trials should start to fail [s]
    double measured = 0;                   ///< where they did [s]
    double step = 0;                       ///< [s]
    std::string end = {}, agreement = {};  ///< how it ended, and whether that agrees with what is expected
};

/// Some lines a method on how its trials ended.
std::string stability_summary(const std::vector<StabilityRow>& rows);

/// A chart a method.
std::vector<Chart> stability_charts(const std::vector<StabilityRow>& rows);

}  // namespace drape
