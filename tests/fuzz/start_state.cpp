// The file of a state to start from, for one cloth or two: read, run from, written, read again.

#include "drape/scene/start_state.h"

#include <algorithm>
#include <optional>
#include <sstream>

#include "drape/session/state_csv.h"
#include "fuzz/small_run.h"
#include "fuzz/target.h"

using namespace drape;

namespace {

bool same_ball(const Ball& one, const Ball& other) {
    return one.centre == other.centre && one.velocity == other.velocity && one.spin == other.spin &&
           one.orientation.coeffs() == other.orientation.coeffs();
}

bool same(const StartState& one, const StartState& other) {
    if (one.time != other.time || one.states.size() != other.states.size()) return false;
    if (!std::ranges::equal(one.balls, other.balls, same_ball)) return false;
    for (std::size_t c = 0; c < one.states.size(); ++c) {
        if (one.states[c].x != other.states[c].x || one.states[c].v != other.states[c].v) return false;
    }
    return true;
}

void try_with(std::string_view text, std::size_t cloths) {
    Settings settings;
    settings.cloths.resize(cloths);
    for (ClothParameters& cloth : settings.cloths) {
        cloth.particles = {3, 2};
        cloth.pinned = {};
    }
    settings.balls.resize(2);
    for (BallSettings& ball : settings.balls) ball.motion = BallMotion::Free;
    std::vector<Grid> grids;
    for (const ClothParameters& cloth : settings.cloths) grids.push_back(cloth.particles);
    std::optional<StartState> start;
    std::istringstream in{std::string(text)};
    if (!fuzz::accepts([&] { start = read_start(in, "fuzz.csv", grids, 2); })) return;
    fuzz::require(start->states.size() == cloths, "a state is one of every cloth");

    fuzz::accepts([&] {
        Simulation simulation("fuzz.toml", settings, start);
        std::stringstream text_of_state;
        write_state_header(text_of_state, simulation);
        write_state(text_of_state, simulation);
        const StartState again = read_start(text_of_state, "again.csv", grids, 2);
        if (start->balls.empty()) start->balls = again.balls;
        fuzz::require(same(again, *start), "a state that was written reads the same");
        fuzz::step_a_little(simulation);
    });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    for (const std::size_t cloths : {1u, 2u}) try_with(fuzz::text_of(data, size), cloths);
    return 0;
}
