#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "drape/base/input_error.h"
#include "drape/scene/settings.h"

namespace drape {

/// A setting's value on its way between text, file and `Settings`: a flag, a number, a name or text, or a list of
/// numbers (vectors, grids, pin lists; a path is its rows one after another).
using SettingValue = std::variant<bool, double, std::string, std::vector<double>>;

enum class SettingKind { Flag, Integer, Number, Choice, Text, Grid, Size, Vector, Pins, Path };

/// The accepted numbers: low <= x <= high.
struct Range {
    double low;
    double high;
};

/// A section of the scene file that may stand several times: for cloths, balls, solids and pins.
struct SeveralSections {
    std::size_t (*count)(const Settings&);
    void (*add)(Settings&);
};

/// One row of the table of settings, from which the scene loader, `--set`, `--help` and `list settings` are made.
struct Setting {
    std::string section;  ///< of the scene file: "cloth", "ball", "solver", ...; empty for the title
    std::string name;     ///< within the section, as in "dt" or "structural.stiffness"
    SettingKind kind;
    std::string unit;                                                        ///< "s", "N/m", ...; empty if none
    Range range;                                                             ///< of every number in the value
    std::vector<std::string> choices;                                        ///< of a Choice or of Pins
    std::string help;                                                        ///< one line
    std::function<SettingValue(const Settings&, std::size_t)> read;          ///< of the index-th cloth, ball, ...
    std::function<void(Settings&, std::size_t, const SettingValue&)> write;  ///< the value was checked
    const SeveralSections* several = nullptr;                                ///< null: the section stands once

    double usual_high = 0;  ///< where a slider ends, if more is accepted than is of use; 0: see `slider_scale`

    struct Word {
        double value;
        std::string text;
    };
    std::optional<Word> word = {};  ///< what one of its numbers means: 0 is "never"

    [[nodiscard]] std::string full_name() const { return section.empty() ? name : section + "." + name; }
};

/// All settings, in the order of the scene file.
std::span<const Setting> setting_table();

/// How many times the section of a setting stands in the settings: for cloths, balls, solids and pins as many as there
/// are, else once.
inline std::size_t section_count(const Settings& settings, const Setting& setting) {
    return setting.several != nullptr ? setting.several->count(settings) : 1;
}

/// The setting called `name`: its full name ("solver.dt") or, where only one setting ends so, its short one ("dt").
/// @throws InputError that names the nearest known one, or the candidates of a short name that fits several
const Setting& find_setting(std::string_view name);

/// The setting of all cloths, balls, solids or pins where the name may be that of one of them: "ball[1].radius".
/// @throws InputError as `find_setting`
const Setting& setting_meant_by(std::string_view name);

/// What panel and messages call the setting: the menu's words where it has any ("time step"), else its name without its
/// section ("structural stiffness"), or, of a section's switch, the section's name.
std::string setting_label(const Setting& setting);

/// Why a setting changes nothing now, for the user: "no effect with rk4"; empty if it does.
/// @param number of the cloth, ball, solid or pins
/// @pre the settings have it
std::string why_without_effect(const Setting& setting, const Settings& settings, std::size_t number);

/// What is accepted, as an error message says it: "1e-09 <= dt <= 0.1 s", "'rk4' or 'velocity_verlet'".
std::string accepted(const Setting& setting);

/// Checks a value against the kind and the range.
/// @return what is wrong, as "solver.dt = 5: allowed 1e-09 <= dt <= 0.1 s"; empty if nothing
std::string refusal(const Setting& setting, const SettingValue& value);

/// The value that a text stands for, unchecked. Lists are "1,2,3" or "[1, 2, 3]"; a number may be its word. A text of
/// no such form stands for itself, which `refusal` refuses.
SettingValue parse_value(const Setting& setting, std::string_view text);

/// The text that `parse_value` reads back.
std::string value_text(const SettingValue& value);

/// A value as panels and messages show it: "on", "2e-04 s", "never".
std::string shown_value(const Setting& setting, const SettingValue& value);

/// What the user calls the setting of one cloth, ball, solid or pins: its full name, with a number where there are
/// several.
std::string name_of(const Setting& setting, std::size_t number, const Settings& settings);

/// The assignments that give a setting the values that it has, one for each cloth, ball, solid or pins that it is of.
/// @throws InputError as `find_setting`
std::vector<std::string> assignments_of(const Settings& settings, std::string_view name);

/// Applies "name=value". The name of a cloth's, ball's, solid's or pins' setting sets all of them, or one:
/// "ball[1].radius" is the second.
/// @throws InputError whose text starts with the setting; `settings` is then unchanged
void assign(Settings& settings, std::string_view assignment);

/// Applies what a command line's `--set` was given, in order.
/// @throws InputError that names the option
void assign_all(Settings& settings, std::span<const std::string> assignments);

/// The settings with a choice moved on to its next name, or a flag to its other value.
/// @throws InputError if the setting is neither
Settings with_next(Settings settings, std::string_view name);

/// The settings with a number changed by `amount` and kept in its range.
/// @throws InputError if the setting is no number
Settings with_added(Settings settings, std::string_view name, double amount);

/// A setting that others forbid; a scene file adds the line that it stands in.
class InconsistentSettings : public InputError {
public:
    InconsistentSettings(std::string of_section, std::size_t of_index, std::string of_name, const std::string& message)
        : InputError(message), section(std::move(of_section)), index(of_index), name(std::move(of_name)) {}

    std::string section;
    std::size_t index;  ///< of the cloth, ball, solid or pins
    std::string name;
};

/// Checks that need more than one setting: pins on the grid, ascending path times, a path where motion is "path", a
/// thickness where cloth meets itself.
/// @throws InconsistentSettings
void check(const Settings& settings);

/// Leaves out the moving pins of which a user's change has left none pinned.
void end_pins_without_particles(Settings& settings);

/// Default settings with a cloth, a ball, a solid and pins: every row of the table can be read from them.
Settings settings_with_one_of_each();

/// The table as text for `--help` and `list settings`: name, default, unit, range, help.
std::string settings_help();

}  // namespace drape
