#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace drape {

/// Reads a whole text as a decimal number in the C locale, whatever the user's locale says.
/// @return nothing if the text is empty, has anything else in it, or is out of a double's range. "nan" and "inf" are
///         numbers here; the caller's range refuses them.
std::optional<double> parse_real(std::string_view text);

/// The text without the blanks around it.
std::string_view trimmed(std::string_view text);

/// The pieces of a text between its commas: one more than there are commas.
std::vector<std::string_view> split_at_commas(std::string_view text);

/// Reads numbers with commas between, blanks about them allowed; nothing if there is anything else.
std::optional<std::vector<double>> parse_reals(std::string_view text);

/// Reads a whole text as an integer in the C locale; nothing if it is anything else.
std::optional<long long> parse_integer(std::string_view text);

/// Reads two of these with a character between: "1280x720".
std::optional<std::pair<long long, long long>> parse_integers(std::string_view text, char between);

/// The shortest text that reads back as the same double, in the C locale.
std::string real_text(double value);

/// `value` with `digits` significant digits, in the C locale; 17 reads back as the same double.
std::string real_text(double value, int digits);

/// FNV-1a, 64 bits, over bytes.
/// @param hash of what came before
std::uint64_t fnv1a(std::string_view bytes, std::uint64_t hash = 14695981039346656037u);

/// The 16 hexadecimal digits of a 64-bit hash.
std::string hash_text(unsigned long long hash);

}  // namespace drape
