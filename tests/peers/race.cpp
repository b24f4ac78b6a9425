#include "race.h"

#include <algorithm>

#include "drape/base/input_error.h"
#include "touching.h"
#include "work_watch.h"

namespace drape::peers {
namespace {

// Long enough for small cloths to be at home in the caches, short enough for the slowest to be waited for
constexpr double shortest_turn = 0.01, longest_turn = 1;  // [s]

class Runner {
public:
    Runner(std::unique_ptr<Method> method, const Motion& motion, bool ours)
        : method_(std::move(method)), motion_(motion), ours_(ours) {
        x_ = motion.frames.back().x;
        method_->start(motion.grid, x_);
    }

    void take_turn(bool timed) {
        double spent = 0;
        const std::size_t once = motion_.frames.size();
        for (std::size_t n = 0; n < once ? spent < longest_turn : spent < shortest_turn; ++n) {
            spent += run(motion_.frames[next_], timed);
            next_ = (next_ + 1) % motion_.frames.size();
        }
    }

    [[nodiscard]] Result result() const {
        return {method_->name(),
                static_cast<int>(totals_.size()),
                ties_,
                median(updates_),
                median(queries_),
                median(totals_),
                ours_};
    }

private:
    static double median(std::vector<double> values) {
        const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
        std::nth_element(values.begin(), middle, values.end());
        return *middle;
    }

    double run(const Frame& frame, bool timed) {
        // Positions are as near as after the step that made them
        x_ = frame.x;
        const WorkWatch update_watch;
        method_->update(x_);
        const double update = update_watch.seconds();
        const WorkWatch query_watch;
        method_->query(x_, frame.ball, touched_);
        const double query = query_watch.seconds();
        if (timed) {
            updates_.push_back(update);
            queries_.push_back(query);
            totals_.push_back(update + query);
        }
        check(frame);
        return update + query;
    }

    void check(const Frame& frame) {
        std::ranges::sort(touched_);
        try {
            ties_ += count_ties(motion_.grid, x_, frame.ball, frame.touched, touched_);
        } catch (const RunError& error) {
            throw RunError(method_->name() + " at " + std::to_string(motion_.grid.nx) + " x " +
                           std::to_string(motion_.grid.ny) + ", frame " + std::to_string(next_) + ": " + error.what());
        }
    }

    std::unique_ptr<Method> method_;
    const Motion& motion_;
    bool ours_;
    Points x_;
    std::vector<int> touched_;
    std::size_t next_ = 0;
    int ties_ = 0;
    std::vector<double> updates_, queries_, totals_;
};

}  // namespace

std::vector<Result> race(const Motion& motion, int turns) {
    Methods methods;
    add_ours(methods);
    const std::size_t ours = methods.size();
    add_fcl(methods);
    add_bullet(methods);
    add_embree(methods);

    std::vector<std::unique_ptr<Runner>> runners;
    for (std::size_t m = 0; m < methods.size(); ++m) {
        // The first of ours is brute force
        runners.push_back(std::make_unique<Runner>(std::move(methods[m]), motion, m > 0 && m < ours));
    }
    // The first turn only warms up
    for (int turn = 0; turn <= turns; ++turn) {
        for (const auto& runner : runners) runner->take_turn(turn > 0);
    }
    std::vector<Result> results;
    for (const auto& runner : runners) results.push_back(runner->result());
    return results;
}

}  // namespace drape::peers
