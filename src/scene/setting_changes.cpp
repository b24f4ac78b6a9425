#include <algorithm>
#include <functional>
#include <optional>
#include <utility>

#include "drape/base/input_error.h"
#include "drape/base/memory_limit.h"
#include "drape/base/numbers.h"
#include "drape/model/cloth_model.h"
#include "drape/scene/memory.h"
#include "drape/scene/setting_table.h"
#include "setting_rows.h"

namespace drape {
namespace {

/// Particles over all cloths; `memory_needed` tells what they take.
constexpr long long max_particles = 4'000'000;

/// A setting's name with the index that it may carry: "ball[1].radius".
struct Target {
    const Setting* setting;
    std::optional<std::size_t> index;
};

Target find_target(std::string_view name) {
    const std::size_t open = name.find('['), close = name.find("].");
    if (open == std::string_view::npos || close == std::string_view::npos || close < open) {
        return {&find_setting(name), std::nullopt};
    }
    const auto index = parse_integer(name.substr(open + 1, close - open - 1));
    if (!index || *index < 0) {
        throw InputError("setting '" + shortened(name) + "': expected a number from 0 in the brackets");
    }
    const std::string plain = std::string(name.substr(0, open)) + std::string(name.substr(close + 1));
    return {&find_setting(plain), static_cast<std::size_t>(*index)};
}

/// The cloths, balls, solids or pins that a target means: all of its section, or the one it names.
/// @throws InputError if there is none
std::pair<std::size_t, std::size_t> range_of(const Settings& settings, const Target& target) {
    const Setting& setting = *target.setting;
    const std::size_t count = section_count(settings, setting);
    if (count == 0) throw InputError(setting.full_name() + ": the scene has no " + setting.section);
    if (!target.index) return {0, count};
    if (*target.index >= count) {
        throw InputError(setting.section + "[" + std::to_string(*target.index) + "]: the scene has " +
                         std::to_string(count) + ", counted from 0");
    }
    return {*target.index, *target.index + 1};
}

void write_checked(Settings& settings, const Target& target, const SettingValue& value) {
    const auto [first, last] = range_of(settings, target);
    if (const std::string wrong = refusal(*target.setting, value); !wrong.empty()) throw InputError(wrong);
    for (std::size_t i = first; i < last; ++i) target.setting->write(settings, i, value);
}

/// @param index of the cloth, ball, solid or pins
/// @param how it does not fit, as it stands after the setting's full name
[[noreturn]] void refuse(const std::string& section, std::size_t index, const std::string& name,
                         const std::string& how) {
    throw InconsistentSettings(section, index, name, section + "." + name + how);
}

void check_cloth(const ClothParameters& cloth, std::size_t index) {
    const int particles = cloth.particles.particles();
    for (const int pin : cloth.pinned.list) {
        if (pin >= 0 && pin < particles) continue;
        refuse("cloth", index, "pinned",
               " = " + std::to_string(pin) + ": allowed 0 <= particle <= " + std::to_string(particles - 1));
    }
}

void check_memory(const Settings& settings) {
    const MemoryLimit limit = memory_limit();
    if (memory_needed(settings) <= limit.bytes) return;
    throw InconsistentSettings(
        "cloth", 0, "particles",
        memory_text(settings) + ": allowed at most " + bytes_text(limit.bytes) + ", " + std::string(limit.whose));
}

/// @param name of the path within its section
void check_times(const std::string& section, std::size_t index, const std::string& name,
                 const std::vector<PathPoint>& path) {
    const auto late = std::ranges::adjacent_find(path, std::ranges::greater_equal(), &PathPoint::time);
    if (late == path.end()) return;
    refuse(section, index, name,
           ": time " + real_text(static_cast<double>((late + 1)->time)) +
               ": allowed only times that ascend from point to point");
}

/// @param section "ball" or "solid"
void check_path(const std::string& section, std::size_t index, bool is_used, const std::vector<PathPoint>& path) {
    if (is_used && path.size() < 2) {
        throw InconsistentSettings(
            section, index, path.empty() ? "motion" : "path",
            section + ".motion = path: allowed only with a " + section + ".path of at least two points [t, x, y, z]");
    }
    check_times(section, index, "path", path);
}

void check_solid(const SolidSettings& solid, std::size_t index) {
    check_path("solid", index, solid.motion == SolidMotion::Path, solid.path);
    if (solid.axis.squaredNorm() < Real(1e-12)) {
        refuse("solid", index, "axis",
               " = " + value_text(setting_value(solid.axis)) + ": allowed a length of at least 1e-06");
    }
    if (solid.shape == SolidKind::Mesh && solid.file.empty()) {
        refuse("solid", index, "shape", " = mesh: allowed only with a solid.file");
    }
}

/// Pins start where the cloth does: nothing is torn from where it was.
void check_pin_path(std::size_t index, const std::string& name, const std::vector<PathPoint>& path) {
    if (path.empty()) return;
    if (path.size() < 2) refuse("pins", index, name, ": allowed only at least two points [t, x, y, z]");
    check_times("pins", index, name, path);
    if (!path.front().centre.isZero(0)) {
        refuse("pins", index, name,
               " begins with " + value_text(setting_value(path.front().centre)) +
                   ": allowed only 0, 0, 0, for pins start where the cloth does");
    }
}

bool pins_any(const ClothParameters& cloth, int first, int last) {
    const Pins& pins = cloth.pinned;
    if (pins.kind == Pins::Kind::List) {
        return std::ranges::any_of(pins.list, [&](int pin) { return pin >= first && pin <= last; });
    }
    int p = first;
    while (p <= last && !is_pinned(pins, cloth.particles, p)) ++p;
    return p <= last;
}

void check_pins(const Settings& settings, std::size_t index) {
    const PinSettings& pins = settings.pins[index];
    const auto count = static_cast<int>(settings.cloths.size());
    if (pins.cloth >= count) {
        refuse("pins", index, "cloth",
               " = " + std::to_string(pins.cloth) + ": allowed 0 <= cloth <= " + std::to_string(count - 1));
    }
    const ClothParameters& cloth = settings.cloths[static_cast<std::size_t>(pins.cloth)];
    const int first = pins.particles.nx, last = pins.particles.ny, particles = cloth.particles.particles();
    const auto refuse_particles = [&](const std::string& allowed) {
        refuse("pins", index, "particles",
               " = [" + std::to_string(first) + ", " + std::to_string(last) + "]: allowed " + allowed);
    };
    if (first > last || last >= particles) {
        refuse_particles("0 <= first <= second <= " + std::to_string(particles - 1));
    }
    if (!pins_any(cloth, first, last)) refuse_particles("only where cloth.pinned pins some of them");
    for (std::size_t other = 0; other < index; ++other) {
        const PinSettings& before = settings.pins[other];
        if (before.cloth != pins.cloth || before.particles.nx > last || before.particles.ny < first) continue;
        refuse_particles("only particles that no other [[pins]] has");
    }
    check_pin_path(index, "shift", pins.shift);
    check_pin_path(index, "turns", pins.turns);
}

/// Cloth keeps away from cloth by its thickness, which has to be well above the depth that resting contacts keep.
void check_self_contact(const Settings& settings) {
    constexpr Real least = Real(1e-4);  // m
    const Real thickness = response_of(settings).pair_thickness;
    if (!settings.contact.self || thickness >= least) return;
    refuse("contact", 0, "self",
           " = true: cloth would keep " + real_text(static_cast<double>(thickness)) +
               " m from cloth, by contact.thickness and half of what particles are from diagonals: "
               "allowed only with at least 0.0001 m");
}

/// What nothing can be solved to is no tolerance.
void check_tolerance(const Settings& settings) {
    constexpr Real least = Real(1e-14);
    const Real tolerance = settings.solver.tolerance;
    if (tolerance == 0 || tolerance >= least) return;
    refuse("solver", 0, "tolerance",
           " = " + real_text(static_cast<double>(tolerance)) + ": allowed 0 and 1e-14 <= tolerance <= 0.1");
}

}  // namespace

void end_pins_without_particles(Settings& settings) {
    std::erase_if(settings.pins, [&](const PinSettings& pins) {
        const auto cloth = static_cast<std::size_t>(pins.cloth);
        return cloth < settings.cloths.size() &&
               !pins_any(settings.cloths[cloth], pins.particles.nx, pins.particles.ny);
    });
}

const Setting& setting_meant_by(std::string_view name) { return *find_target(name).setting; }

std::string name_of(const Setting& setting, std::size_t number, const Settings& settings) {
    if (section_count(settings, setting) <= 1) return setting.full_name();
    return setting.section + "[" + std::to_string(number) + "]." + setting.name;
}

std::vector<std::string> assignments_of(const Settings& settings, std::string_view name) {
    const Target target = find_target(name);
    const Setting& setting = *target.setting;
    std::vector<std::string> assignments;
    for (std::size_t i = 0; i < section_count(settings, setting); ++i) {
        if (target.index.value_or(i) != i) continue;
        assignments.push_back(name_of(setting, i, settings) + "=" + value_text(setting.read(settings, i)));
    }
    return assignments;
}

void assign(Settings& settings, std::string_view assignment) {
    const std::size_t equals = assignment.find('=');
    if (equals == std::string_view::npos || equals == 0) {
        throw InputError("'" + shortened(assignment) + "': expected name=value");
    }
    const Target target = find_target(assignment.substr(0, equals));
    write_checked(settings, target, parse_value(*target.setting, assignment.substr(equals + 1)));
}

void assign_all(Settings& settings, std::span<const std::string> assignments) {
    for (const std::string& assignment : assignments) {
        try {
            assign(settings, assignment);
        } catch (const InputError& error) {
            throw InputError("--set " + shortened(assignment) + ": " + error.what());
        }
    }
}

Settings with_next(Settings settings, std::string_view name) {
    const Target target = find_target(name);
    const Setting& setting = *target.setting;
    const SettingValue now = setting.read(settings, range_of(settings, target).first);
    if (setting.kind == SettingKind::Flag) {
        write_checked(settings, target, !std::get<bool>(now));
    } else if (setting.kind == SettingKind::Choice) {
        const auto at = std::find(setting.choices.begin(), setting.choices.end(), std::get<std::string>(now));
        const bool wraps = at == setting.choices.end() || at + 1 == setting.choices.end();
        write_checked(settings, target, wraps ? setting.choices.front() : *(at + 1));
    } else {
        throw InputError("next " + setting.full_name() + ": it is neither a choice nor true or false");
    }
    return settings;
}

Settings with_added(Settings settings, std::string_view name, double amount) {
    const Target target = find_target(name);
    const Setting& setting = *target.setting;
    if (setting.kind != SettingKind::Number && setting.kind != SettingKind::Integer) {
        throw InputError("add " + setting.full_name() + ": it is no number");
    }
    const auto [first, last] = range_of(settings, target);
    for (std::size_t i = first; i < last; ++i) {
        const double sum = std::get<double>(setting.read(settings, i)) + amount;
        write_checked(settings, {&setting, i}, std::clamp(sum, setting.range.low, setting.range.high));
    }
    return settings;
}

void check(const Settings& settings) {
    long long particles = 0;
    for (std::size_t c = 0; c < settings.cloths.size(); ++c) {
        check_cloth(settings.cloths[c], c);
        particles += settings.cloths[c].particles.particles();
        if (particles <= max_particles) continue;
        refuse("cloth", c, "particles",
               ": " + std::to_string(particles) + " in all: allowed at most " + std::to_string(max_particles));
    }
    check_memory(settings);
    check_self_contact(settings);
    check_tolerance(settings);
    for (std::size_t b = 0; b < settings.balls.size(); ++b) {
        check_path("ball", b, settings.balls[b].motion == BallMotion::Path, settings.balls[b].path);
    }
    for (std::size_t s = 0; s < settings.solids.size(); ++s) check_solid(settings.solids[s], s);
    for (std::size_t p = 0; p < settings.pins.size(); ++p) check_pins(settings, p);
}

}  // namespace drape
