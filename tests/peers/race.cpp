#include "race.h"

#include <algorithm>

#include "touching.h"

namespace drape::peers {
namespace {

class BallRunner final : public Runner {
public:
    BallRunner(std::unique_ptr<Method> method, const Motion& motion, bool ours)
        : Runner(method->name(), motion.frames.size(), ours), method_(std::move(method)), motion_(motion) {
        x_ = motion.frames.back().x;
        method_->start(motion.grid, x_);
    }

private:
    void prepare(std::size_t frame) override {
        x_ = motion_.frames[frame].x;
        ball_ = motion_.frames[frame].ball;
    }
    void update() override { method_->update(x_); }
    void query() override { method_->query(x_, ball_, touched_); }

    int check(std::size_t frame) override {
        std::ranges::sort(touched_);
        return count_ties(motion_.grid, x_, ball_, motion_.frames[frame].touched, touched_);
    }

    std::unique_ptr<Method> method_;
    const Motion& motion_;
    Points x_;
    Ball ball_;
    std::vector<int> touched_;
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
        runners.push_back(std::make_unique<BallRunner>(std::move(methods[m]), motion, m > 0 && m < ours));
    }
    return take_turns(runners, turns);
}

}  // namespace drape::peers
