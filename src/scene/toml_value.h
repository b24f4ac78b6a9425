#pragma once

// The parser's own assertions abort on bad input; without them it reports an error as it should.
#define TOML_HEADER_ONLY 1
#define TOML_ASSERT(condition) static_cast<void>(0)
#include <toml++/toml.h>

#include <optional>
#include <string>
#include <string_view>

#include "drape/scene/setting_table.h"

namespace drape {

/// Parses a TOML document.
/// @throws InputError as `file:line:column: reason`
toml::table parse_toml(std::string_view text, const std::string& file);

/// A node's value in the form that a kind of setting has; nothing if the node is of another type.
std::optional<SettingValue> toml_value(const toml::node& node, SettingKind kind);

/// The node as it might stand in a file, shortened, for messages.
std::string toml_text(const toml::node& node);

}  // namespace drape
