#pragma once

#include <algorithm>
#include <functional>
#include <memory>

#include "drape/base/copied.h"
#include "drape/base/workers.h"

namespace drape {

/// Workers that start when there is work for more than one of them; a copy starts its own.
class LazyWorkers {
public:
    /// @param threads the caller's own included, at least 1
    void use(int threads) {
        if (threads != threads_) workers_.reset();
        threads_ = threads;
    }

    /// Calls work(part, parts) for each of some parts, see `Workers::run`.
    /// @param most parts that the work is worth; there are no more than threads, and one or more
    template <class Work>
    void run(std::size_t most, Work work) {
        int parts = static_cast<int>(std::clamp<std::size_t>(most, 1, static_cast<std::size_t>(threads_)));
        if (parts > 1 && !workers_) workers_ = std::make_shared<Workers>(threads_);
        if (parts > 1) parts = std::min(parts, workers_->threads());
        if (parts == 1) return work(0, 1);
        const auto part_of = [&](int part) { work(part, parts); };
        workers_->run(parts, std::cref(part_of));
    }

private:
    int threads_ = 1;
    ScratchOnCopy<std::shared_ptr<Workers>> workers_;
};

}  // namespace drape
