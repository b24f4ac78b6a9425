// Results do not depend on the number of threads.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "sim/small_scene.h"

namespace drape {
namespace {

TEST(Threads, OfAnyNumberGiveTheSameBits) {
    for (const char* integrator : {"explicit_euler", "symplectic_euler", "velocity_verlet", "rk4", "backward_euler"}) {
        std::vector<std::uint64_t> hashes;
        for (const std::string threads : {"threads=1", "threads=2", "threads=7"}) {
            Settings settings = small_settings();
            settings.cloths[0].particles = {300, 200};  // enough for each of the threads to get some
            const bool implicit = std::string(integrator) == "backward_euler";  // by multigrid, where steps are long
            for (const std::string& set :
                 {std::string(implicit ? "dt=0.01" : "dt=1e-5"), std::string("integrator=") + integrator, threads}) {
                assign(settings, set);
            }
            Simulation simulation("drop", std::move(settings));
            for (int i = 0; i < 5; ++i) simulation.step();
            hashes.push_back(simulation.hash());
        }
        EXPECT_EQ(hashes[1], hashes[0]) << integrator;
        EXPECT_EQ(hashes[2], hashes[0]) << integrator;
    }
}

TEST(Threads, AndLedgerChangeNoSubstepsAndDoNotMakeBdf2Forget) {
    for (const std::vector<std::string>& settings : {std::vector<std::string>{"dt=0.0078125", "on_unstable=substep"},
                                                     {"integrator=bdf2", "ball.position=0,-9,0"}}) {
        Simulation plain = small_simulation(settings), other = small_simulation(settings);
        make_steps(plain, 20), make_steps(other, 20);
        send(other, "set solver.threads=2");
        send(other, "set solver.ledger=true");
        make_steps(plain, 40), make_steps(other, 40);
        EXPECT_EQ(plain.hash(), other.hash()) << settings[0];
    }
}

}  // namespace
}  // namespace drape
