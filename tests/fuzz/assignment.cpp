// What stands after `--set`: a line each, applied one after another to a scene of two cloths, two balls, two solids and
// two groups of pins.

#include <sstream>
#include <string>

#include "drape/scene/setting_table.h"
#include "fuzz/small_run.h"
#include "fuzz/target.h"

using namespace drape;

namespace {

constexpr int most_lines = 8;

Settings two_of_each() {
    Settings settings;
    settings.cloths.resize(2);
    for (ClothParameters& cloth : settings.cloths) cloth.particles = {4, 3};
    settings.balls.resize(2);
    settings.solids.resize(2);
    settings.cloths[0].pinned.kind = Pins::Kind::Row;
    settings.pins.resize(2);
    settings.pins[1].particles = {1, 3};
    return settings;
}

/// Every value that is in the settings has a text that stands for it.
void check_texts(const Settings& settings) {
    for (const Setting& setting : setting_table()) {
        const SettingValue value = setting.read(settings, 0);
        if (setting.kind == SettingKind::Path && std::get<std::vector<double>>(value).empty()) continue;
        const std::string text = value_text(value);
        fuzz::require(parse_value(setting, text) == value, "a value's text stands for the value");
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    Settings settings = two_of_each();
    std::istringstream lines{std::string(fuzz::text_of(data, size))};
    bool any = false;
    std::string line;
    for (int count = 0; count < most_lines && std::getline(lines, line); ++count) {
        any |= fuzz::accepts([&] { assign_all(settings, {&line, 1}); });
        fuzz::accepts([&] { settings = with_next(settings, line); });
    }
    if (!any || !fuzz::accepts([&] { check(settings); })) return 0;
    check_texts(settings);
    const auto small = fuzz::made_small(settings);
    if (!small) return 0;
    fuzz::accepts([&] {
        Simulation simulation("fuzz.toml", *small);
        fuzz::step_a_little(simulation);
    });
    return 0;
}
