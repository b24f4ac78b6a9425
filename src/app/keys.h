#pragma once

#include <string>

namespace drape {

/// The name of a key that makes a character, as entries spell it: "P", "Shift+O", "Ctrl+Shift+Z", "Space", "?";
/// empty if it has none.
/// @param code as GLUT gives it: with Control, letters come as control codes
/// @param shift whether Shift is down; it is part of a letter's name only
/// @param control whether Control is down; only letters have a name with it
std::string character_key(unsigned char code, bool shift, bool control);

/// The name of a key that makes none: "Left", "PageUp", "F12", "Shift+F12"; empty if no entry can have it.
/// @param shift whether Shift is down; it is part of a function key's name only
std::string special_key(int code, bool shift);

/// A key's name as it is without Shift and Control: the same for the press and the release, where one of these was let
/// go between them.
std::string without_modifiers(const std::string& key);

}  // namespace drape
