// No ball goes through a cloth unseen, however fast: 1 cm at up to 100 m/s, at steps of 1/60 s.

#include <gtest/gtest.h>

#include "drape/base/exact_math.h"
#include "drape/bounds/broad_phase.h"
#include "drape/bounds/displacement.h"
#include "drape/contact/detection.h"
#include "support/containment.h"

namespace drape {
namespace {

/// A sheet that hangs in a plane and swings at right angles to it, each particle by itself: at any time a point is on
/// one side of it or on the other. Balls that begin before it and end behind it, within its outline, have crossed it.
class Sheet {
public:
    static constexpr Real thickness = Real(0.002), radius = Real(0.01);

    explicit Sheet(unsigned seed) : random_(seed) {
        from.resize(grid.particles(), 3);
        for (int j = 0; j < grid.ny; ++j) {
            for (int i = 0; i < grid.nx; ++i) from.row(grid.particle(i, j)) << side(i), side(j), 0;
        }
        to = from;
        swing();
    }

    /// On to the next step: all of it moves by up to 20 cm, and each particle by a little more or less.
    void swing() {
        from.col(2) = to.col(2);
        const Real middle = Real(0.1) * draw(), rough = Real(0.01) * std::abs(draw());
        for (Real& z : to.col(2).reshaped()) z = middle + rough * draw();
    }

    /// @return a ball that crosses the sheet within the step, at up to 100 m/s, where it ends
    Ball cross() {
        const Real aside = Real(0.45);
        Vec3 start(aside * draw(), aside * draw(), 0), end(aside * draw(), aside * draw(), 0);
        if (random_() % 2 == 0) {
            start[2] = from.col(2).maxCoeff() + gap(), end[2] = to.col(2).minCoeff() - gap();
        } else {
            start[2] = from.col(2).minCoeff() - gap(), end[2] = to.col(2).maxCoeff() + gap();
        }
        return {.centre = end, .radius = radius, .moved = end - start};
    }

    static constexpr Grid grid{30, 30};
    Points from, to;

private:
    static Real side(int k) { return static_cast<Real>(k) / static_cast<Real>(grid.nx - 1) - Real(0.5); }
    Real draw() { return uniform<Real>(random_); }

    /// More than touches: often by little.
    Real gap() {
        const Real part = draw();
        return (radius + thickness) * Real(1.001) + Real(0.35) * part * part * part * part;
    }

    std::mt19937 random_;
};

struct Shots {
    long shots = 0, through = 0, discrete = 0;
};

/// Shoots, and counts the balls that no contact would throw back; and those that positions after the step alone miss.
Shots shoot(const BroadPhaseParameters& parameters, int steps, int balls) {
    Sheet sheet(static_cast<unsigned>(steps + static_cast<int>(parameters.volume)));
    const auto tree = make_broad_phase(parameters, Sheet::grid);
    Candidates found;
    std::vector<ContactRow> contacts;
    const auto is_met = [&](const Ball& ball, Real reach) {
        contacts.clear();
        find_contacts({Sheet::grid, sheet.from, sheet.to}, ball, {0, Sheet::thickness, reach}, found.cells, contacts,
                      Kernels::Vector);
        return std::ranges::any_of(contacts, [](const ContactRow& contact) { return contact.depth > 0; });
    };
    Shots count;
    for (int step = 0; step < steps; ++step) {
        sheet.swing();
        tree->build(sheet.to);
        const Real moved = largest_displacement(sheet.to, sheet.from);
        for (int shot = 0; shot < balls; ++shot) {
            const Ball ball = sheet.cross();
            const Real reach = moved + ball.moved.norm();
            tree->query(grown(ball, Sheet::thickness + 2 * reach), found);
            ++count.shots;
            count.through += !is_met(ball, reach);
            count.discrete += !is_met(ball, 0);
        }
    }
    return count;
}

/// Every volume by every update.
Shots shoot_all(int steps, int balls) {
    Shots sum;
    for (const VolumeKind volume : values_of<VolumeKind>()) {
        for (const UpdateKind update : values_of<UpdateKind>()) {
            const Shots shots = shoot({.volume = volume, .update = update}, steps, balls);
            EXPECT_EQ(shots.through, 0) << name_of(volume) << ", " << name_of(update);
            sum.shots += shots.shots, sum.through += shots.through, sum.discrete += shots.discrete;
        }
    }
    return sum;
}

TEST(Bullets, NeverGoThroughUnseen) {
    const Shots shots = shoot_all(50, 10);
    EXPECT_GE(shots.shots, 20'000);
    EXPECT_EQ(shots.discrete, shots.shots) << "positions after the steps alone show none of them";
}

// Run by `ctest -L nightly`
TEST(NightlyBullets, NeverGoThroughUnseen) {
    const Shots shots = shoot_all(2'500, 10);
    EXPECT_GE(shots.shots, 1'000'000);
}

}  // namespace
}  // namespace drape
