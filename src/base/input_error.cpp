#include "drape/base/input_error.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace drape {
namespace {

/// Levenshtein's distance: insertions, deletions and substitutions of single bytes.
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t substituted = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
            diagonal = row[j];
            row[j] = std::min({row[j] + 1, row[j - 1] + 1, substituted});
        }
    }
    return row[b.size()];
}

/// A byte as C writes it.
std::string escaped(unsigned char byte) {
    constexpr std::string_view digits = "0123456789abcdef";
    if (byte == '\n') return "\\n";
    if (byte == '\r') return "\\r";
    if (byte == '\t') return "\\t";
    return {'\\', 'x', digits[byte / 16], digits[byte % 16]};
}

/// Whether a UTF-8 text has one of the control characters U+0080 to U+009F here, of which terminals know some.
bool is_wide_control(std::string_view text) {
    return text.size() > 1 && text[0] == '\xc2' && static_cast<unsigned char>(text[1]) < 0xa0;
}

}  // namespace

InputError::InputError(const std::string& message, const std::string& hint)
    : std::runtime_error(one_line(message) + (hint.empty() ? "" : "\n") + one_line(hint)) {}

std::string one_line(std::string_view text) {
    constexpr std::size_t longest = 2000;
    std::string line;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto byte = static_cast<unsigned char>(text[i]);
        if (byte < ' ' || byte == 127 || is_wide_control(text.substr(i))) {
            line += escaped(byte);
            if (byte > 127) line += escaped(static_cast<unsigned char>(text[++i]));
        } else {
            line += text[i];
        }
    }
    // File and line stand at its beginning, and what is allowed at its end
    if (line.size() <= longest) return line;
    return line.substr(0, longest / 2) + " ... " + line.substr(line.size() - longest / 2);
}

std::string shortened(std::string_view value) {
    constexpr std::size_t longest = 100;
    if (value.size() <= longest) return std::string(value);
    std::size_t end = longest;
    while (end > 0 && (static_cast<unsigned char>(value[end]) & 0xc0) == 0x80) --end;  // not within a letter
    return std::string(value.substr(0, end)) + "...";
}

std::string did_you_mean(std::string_view name, std::span<const std::string> names, std::string_view otherwise) {
    const std::string_view head = name.substr(0, 100);  // a longer name is no typing error
    std::size_t allowed = std::min<std::size_t>((head.size() + 2) / 3, 3);
    std::string text(otherwise);
    for (const std::string& one : names) {
        const std::size_t edits = edit_distance(head, one);
        if (edits > allowed || (edits == allowed && text != otherwise)) continue;
        allowed = edits;
        text = ": did you mean '" + one + "'?";
    }
    return text;
}

std::string listed(std::span<const std::string> names) {
    std::string text;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (i > 0) text += i + 1 == names.size() ? " or " : ", ";
        text += "'" + names[i] + "'";
    }
    return text;
}

}  // namespace drape
