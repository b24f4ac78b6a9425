#include "runner.h"

#include <algorithm>
#include <cstdio>
#include <ctime>

#include "drape/base/input_error.h"
#include "drape/base/stopwatch.h"

namespace drape::peers {
namespace {

// Long enough for small cloths to be at home in the caches, short enough for the slowest to be waited for
constexpr double shortest_turn = 0.01, longest_turn = 1;  // [s]

/// How long a piece of work took on a machine that is shared: wall time, or the processor time of this program if that
/// is less, because the processor was lent to others meanwhile.
class WorkWatch {
public:
    [[nodiscard]] double seconds() const {
        const double wall = wall_.seconds();
        return std::min(wall, processor_seconds() - start_);
    }

private:
    static double processor_seconds() {
        timespec now{};
        clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
        return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
    }

    // In this order: the wall time is not to hold the call for the processor time
    double start_ = processor_seconds();
    Stopwatch wall_;
};

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

}  // namespace

void Runner::take_turn(bool timed) {
    double spent = 0;
    for (std::size_t n = 0; n < frames_ ? spent < longest_turn : spent < shortest_turn; ++n) {
        spent += run(timed);
        next_ = (next_ + 1) % frames_;
    }
}

Result Runner::result() const {
    return {method_, static_cast<int>(totals_.size()), ties_, median(updates_), median(queries_), median(totals_)};
}

double Runner::run(bool timed) {
    prepare(next_);
    const WorkWatch update_watch;
    update();
    const double update = update_watch.seconds();
    const WorkWatch query_watch;
    query();
    const double query = query_watch.seconds();
    if (timed) {
        updates_.push_back(update);
        queries_.push_back(query);
        totals_.push_back(update + query);
    }
    try {
        ties_ += check(next_);
    } catch (const RunError& error) {
        throw RunError(method_ + ", frame " + std::to_string(next_) + ": " + error.what());
    }
    return update + query;
}

void tell(std::ostream& out, const std::string& row) {
    out << row << '\n';
    std::puts(row.c_str());
    std::fflush(stdout);
}

std::vector<Result> take_turns(const Runners& runners, int turns) {
    for (int turn = 0; turn <= turns; ++turn) {
        for (const auto& runner : runners) runner->take_turn(turn > 0);
    }
    std::vector<Result> results;
    for (const auto& runner : runners) results.push_back(runner->result());
    return results;
}

}  // namespace drape::peers
