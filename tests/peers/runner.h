#pragma once

#include <array>
#include <functional>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

namespace drape::peers {

/// Medians over the frames that a method was timed on.
struct Result {
    std::string method;
    int frames = 0;
    int ties = 0;       ///< what rounding has decided otherwise than brute force, of all frames
    double update = 0;  ///< [s]
    double query = 0;   ///< down to what is sought [s]
    double total = 0;   ///< of both in one frame [s]
};

/// A way to find what may touch, in a race with others, and where it is in the motion.
class Runner {
public:
    /// @param frames of the motion; after the last comes the first
    Runner(std::string method, std::size_t frames) : method_(std::move(method)), frames_(frames) {}
    virtual ~Runner() = default;
    Runner(const Runner&) = delete;
    Runner& operator=(const Runner&) = delete;

    /// Runs through the motion, again and again for at least 10 ms and for no longer than 1 s, from where it stopped.
    /// @throws RunError if the method finds something else than brute force
    void take_turn(bool timed);

    [[nodiscard]] Result result() const;

protected:
    /// What is not timed: positions are as near as after the step that made them.
    virtual void prepare(std::size_t frame) = 0;

    /// Follows the cloth to its present positions.
    virtual void update() = 0;
    virtual void query() = 0;

    /// @return ties
    /// @throws RunError if what was found is wrong
    virtual int check(std::size_t frame) = 0;

private:
    double run(bool timed);

    std::string method_;
    std::size_t frames_;
    std::size_t next_ = 0;
    int ties_ = 0;
    std::vector<double> updates_, queries_, totals_;
};

using Runners = std::vector<std::unique_ptr<Runner>>;

/// A runner whose motion is one frame and whose parts are functions.
class OneFrame final : public Runner {
public:
    using Part = std::function<void()>;
    OneFrame(const std::string& name, Part prepare, Part update, Part query, Part check)
        : Runner(name, 1), parts_{std::move(prepare), std::move(update), std::move(query), std::move(check)} {}

private:
    void prepare(std::size_t /*frame*/) override { parts_[0](); }
    void update() override { parts_[1](); }
    void query() override { parts_[2](); }
    int check(std::size_t /*frame*/) override { return parts_[3](), 0; }

    std::array<Part, 4> parts_;
};

/// Writes a row of a table, and prints it.
void tell(std::ostream& out, const std::string& row);

/// How far Drape's and Bullet's methods are from the converged sheet after a while, by their steps, and at what cost.
void race_with_cloth(bool quick, std::ostream& out);

/// What each solver needs for the system of an implicit step, to one residual.
void race_to_solve(bool quick, std::ostream& out);

/// All take their turns in their order; the first turn only warms up.
std::vector<Result> take_turns(const Runners& runners, int turns);

}  // namespace drape::peers
