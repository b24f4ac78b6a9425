#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "drape/sim/command.h"
#include "drape/sim/setting_table.h"
#include "drape/sim/simulation.h"

namespace drape {

/// What follows an entry's text in the menu: whether what its command switches is on, or the value that it sets the
/// present one. The command is read once.
class MenuMark {
public:
    /// @param command in text form
    /// @throws InputError if it is none, or has a setting that is none
    explicit MenuMark(std::string_view command);

    /// "  - on", "  - off", "  - paused", "  - now"; empty for what is neither.
    [[nodiscard]] std::string text(const Simulation& simulation) const;

private:
    Command command_;
    const Setting* setting_ = nullptr;   ///< that it names, if any
    std::optional<SettingValue> value_;  ///< that it sets it to
};

}  // namespace drape
