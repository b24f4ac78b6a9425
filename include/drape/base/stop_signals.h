#pragma once

#include <array>
#include <csignal>

namespace drape {

/// Takes SIGINT, SIGTERM and SIGHUP while it lives, for whoever works to ask after between two steps. The first one is
/// told; any further one ends the program at once, as it does where nobody asks. One that is ignored stays so
/// (nohup, the background of a script). Which threads there are does not matter, nor when they were started.
class StopSignals {
public:
    /// @pre there is no other object of this kind
    StopSignals();
    ~StopSignals();
    StopSignals(const StopSignals&) = delete;
    StopSignals& operator=(const StopSignals&) = delete;

    /// The number of the first signal that came, 0 if none did.
    /// @par Cost one read of a flag
    [[nodiscard]] int arrived() const;

private:
    static constexpr std::array numbers{SIGINT, SIGTERM, SIGHUP};
    std::array<struct sigaction, numbers.size()> before_{};
};

}  // namespace drape
