#include "drape/base/stop_signals.h"

#include <ctime>

namespace drape {

StopSignals::StopSignals() {
    sigemptyset(&awaited_);
    sigaddset(&awaited_, SIGINT);
    sigaddset(&awaited_, SIGTERM);
    pthread_sigmask(SIG_BLOCK, &awaited_, &before_);
}

StopSignals::~StopSignals() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

int StopSignals::arrived() const {
    const timespec at_once{0, 0};
    const int number = sigtimedwait(&awaited_, nullptr, &at_once);
    return number > 0 ? number : 0;
}

}  // namespace drape
