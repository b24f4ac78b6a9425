#pragma once

#include <string>

namespace drape {

/// The name of a key that makes a character, as entries spell it: "P", "Shift+O", "Space", "?"; empty if it has none.
/// @param code as GLUT gives it: with Control, letters come as control codes, which have no entry
/// @param shift whether Shift is down; it is part of a letter's name only
std::string character_key(unsigned char code, bool shift);

/// The name of a key that makes none: "Left", "PageUp", "F12", "Shift+F12"; empty if no entry can have it.
/// @param shift whether Shift is down; it is part of a function key's name only
std::string special_key(int code, bool shift);

/// A key's name as it is without Shift: the same for the press and the release, where Shift was let go between them.
std::string without_shift(const std::string& key);

}  // namespace drape
