// A scene file: read, written, read again, and run for two steps.

#include "drape/scene/scene.h"

#include <optional>

#include "fuzz/small_run.h"
#include "fuzz/target.h"

using namespace drape;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::optional<Settings> settings;
    if (!fuzz::accepts([&] { settings = parse_scene(fuzz::text_of(data, size), "fuzz.toml"); })) return 0;

    std::optional<Settings> again;
    const bool reads_back = fuzz::accepts([&] { again = parse_scene(scene_text(*settings), "again.toml"); });
    fuzz::require(reads_back && fuzz::same_settings(*settings, *again), "a scene that was written reads the same");

    const auto small = fuzz::made_small(*settings);
    if (!small) return 0;
    fuzz::accepts([&] {
        Simulation simulation("fuzz.toml", *small);
        fuzz::step_a_little(simulation);
    });
    return 0;
}
