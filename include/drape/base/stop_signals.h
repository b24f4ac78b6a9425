#pragma once

#include <csignal>

namespace drape {

/// Holds SIGINT and SIGTERM back while it lives, for the main loop to ask after. Threads that are started meanwhile
/// hold them back too.
class StopSignals {
public:
    StopSignals();
    ~StopSignals();
    StopSignals(const StopSignals&) = delete;
    StopSignals& operator=(const StopSignals&) = delete;

    /// The number of a signal that came, 0 if none did.
    [[nodiscard]] int arrived() const;

private:
    sigset_t awaited_{};
    sigset_t before_{};
};

}  // namespace drape
