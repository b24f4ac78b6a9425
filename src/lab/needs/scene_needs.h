#pragma once

#include <limits>
#include <optional>
#include <string>

#include "motion.h"

namespace drape {

/// What a scene's needs say about a configuration that was tried.
struct Attempt {
    Settings settings;
    double error = 0;           ///< against the full model, of the cloth's side; 0 if none is stated
    double cost = 0;            ///< CPU time of all threads per simulated second [s/s]
    double miss = 0;            ///< the worst of what was measured over what is allowed; above 1 it does not qualify
    bool beyond_limit = false;  ///< its step is too near to the method's limit, or above: it was not run
    std::string why;            ///< it does not qualify; empty if it does

    [[nodiscard]] bool qualifies() const { return why.empty(); }
};

/// What a scene must show, and whether a configuration of it does.
class Needs {
public:
    /// Computes the full model, where an error against it is stated.
    /// @throws InputError if nothing is stated
    /// @throws RunError if the full model itself diverges
    explicit Needs(Settings scene);

    /// Runs a configuration and says whether it qualifies. Besides what the scene states, a method with a limited step
    /// must keep below nine tenths of it, as `on_unstable = "substep"` does; but for a scene that is to diverge.
    /// @param cost_limit it is given up where it costs more [s/s]
    [[nodiscard]] Attempt attempt(const Settings& settings,
                                  double cost_limit = std::numeric_limits<double>::infinity()) const;

    /// Finds out what the full model is worth: by how much it differs at twice its step or from a disturbed start.
    /// @return a line that says so; empty if no error is stated
    /// @throws InputError if particles are to be compared where a small error grows beyond `most_growth`
    /// @throws RunError if it is known too little for the error that the scene allows
    [[nodiscard]] std::string check_full_model() const;

    [[nodiscard]] const Settings& scene() const { return scene_; }
    [[nodiscard]] const Settings& full() const { return full_; }
    [[nodiscard]] bool states_error() const { return scene_.needs.position_error > 0; }

private:
    [[nodiscard]] double error_of(const Motion& motion) const;

    Settings scene_, full_;
    std::optional<Motion> motion_;  ///< of the full model
};

/// A part of the cloth's side as a text in per cent.
std::string percent(double part);

}  // namespace drape
