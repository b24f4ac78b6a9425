#pragma once

#include <cstdint>
#include <iostream>
#include <random>
#include <string>
#include <vector>

#include "drape/base/numbers.h"
#include "drape/sim/simulation.h"

namespace drape::test {

/// Random numbers that are the same everywhere: the standard library's distributions differ from one to another.
class Chance {
public:
    explicit Chance(unsigned long seed) : random_(seed) {}

    std::size_t below(std::size_t bound) { return static_cast<std::size_t>(random_() % bound); }
    double between(double low, double high) {
        return low + (high - low) * static_cast<double>(random_() >> 11) * 0x1p-53;
    }

    /// Three numbers of a command, up to `away` from those of a point.
    std::string vector(double away, const Vec3& middle = Vec3::Zero()) {
        std::string text;
        for (const Real place : middle) text += " " + real_text(static_cast<double>(place) + between(-away, away), 4);
        return text;
    }

private:
    std::mt19937_64 random_;
};

/// A simulation under random commands, which are told where something goes wrong.
class RandomUser : public Chance {
public:
    RandomUser(unsigned long seed, Simulation played) : Chance(seed), simulation(std::move(played)) {}

    void send(const std::string& command) {
        done_.push_back(std::to_string(simulation.report().step) + " " + command);
        simulation.apply(parse_command(command));
        if (command == "reset") done_.clear();
    }

    /// Says what is wrong after which commands, and begins again.
    void fail(const std::string& what) {
        std::cout << what << "\n  " << simulation.scene() << ", step " << simulation.report().step << " "
                  << simulation.report().error << simulation.run_warning() << "\n";
        for (const std::string& command : done_) std::cout << "  " << command << "\n";
        send("reset");
    }

    Simulation simulation;

private:
    std::vector<std::string> done_;  ///< since the start
};

}  // namespace drape::test
