#include "drape/base/numbers.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace drape {
namespace {

/// The number that the whole text is, in the C locale.
template <class Number>
std::optional<Number> parse_whole(std::string_view text) {
    if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return value;
}

template <class... Format>
std::string text_of(double value, Format... format) {
    std::array<char, 64> buffer;
    const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, format...);
    return {buffer.data(), result.ptr};
}

}  // namespace

std::optional<double> parse_real(std::string_view text) { return parse_whole<double>(text); }

std::optional<long long> parse_integer(std::string_view text) { return parse_whole<long long>(text); }

std::optional<std::pair<long long, long long>> parse_integers(std::string_view text, char between) {
    const std::size_t mark = text.find(between);
    if (mark == std::string_view::npos) return std::nullopt;
    const auto first = parse_integer(text.substr(0, mark)), second = parse_integer(text.substr(mark + 1));
    if (!first || !second) return std::nullopt;
    return std::pair(*first, *second);
}

std::string_view trimmed(std::string_view text) {
    const std::size_t begin = std::min(text.find_first_not_of(" \t"), text.size());
    return text.substr(begin, text.find_last_not_of(" \t") + 1 - begin);
}

std::vector<std::string_view> split_at_commas(std::string_view text) {
    std::vector<std::string_view> pieces;
    for (std::size_t comma = 0; (comma = text.find(',')) != std::string_view::npos; text.remove_prefix(comma + 1)) {
        pieces.push_back(text.substr(0, comma));
    }
    pieces.push_back(text);
    return pieces;
}

std::optional<std::vector<double>> parse_reals(std::string_view text) {
    std::vector<double> numbers;
    for (const std::string_view word : split_at_commas(text)) {
        const auto number = parse_real(trimmed(word));
        if (!number) return std::nullopt;
        numbers.push_back(*number);
    }
    return numbers;
}

std::string real_text(double value) { return text_of(value); }

std::string real_text(double value, int digits) { return text_of(value, std::chars_format::general, digits); }

std::uint64_t fnv1a(std::string_view bytes, std::uint64_t hash) {
    for (const char byte : bytes) hash = (hash ^ static_cast<unsigned char>(byte)) * 1099511628211u;
    return hash;
}

std::string hash_text(unsigned long long hash) {
    std::string text(16, '0');
    for (std::size_t i = 0; i < 16; ++i) text[15 - i] = "0123456789abcdef"[(hash >> (4 * i)) & 15];
    return text;
}

}  // namespace drape
