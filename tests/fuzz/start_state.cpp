// The file of a state to start from, for one cloth or two: read, run from, written, read again.

#include "drape/sim/start_state.h"

#include <optional>
#include <sstream>

#include "drape/sim/state_csv.h"
#include "fuzz/memory_file.h"
#include "fuzz/small_run.h"
#include "fuzz/target.h"

using namespace drape;

namespace {

bool same(const StartState& one, const StartState& other) {
    if (one.time != other.time || one.states.size() != other.states.size()) return false;
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
    settings.balls.emplace_back();
    const fuzz::MemoryFile file(text);
    Settings from_file = settings;
    from_file.start = file.name();
    std::optional<StartState> start;
    if (!fuzz::accepts([&] { start = find_start(from_file); })) return;
    fuzz::require(start && start->states.size() == cloths, "a state is one of every cloth");

    fuzz::accepts([&] {
        Simulation simulation("fuzz.toml", settings, start);
        std::ostringstream out;
        write_state_header(out, simulation);
        write_state(out, simulation);
        const fuzz::MemoryFile written(out.str());
        from_file.start = written.name();
        fuzz::require(same(*find_start(from_file), *start), "a state that was written reads the same");
        fuzz::step_a_little(simulation);
    });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    for (const std::size_t cloths : {1u, 2u}) try_with(fuzz::text_of(data, size), cloths);
    return 0;
}
