#include "share.h"

#include "drape/base/input_error.h"
#include "drape/base/numbers.h"

namespace drape {

Share parse_share(const std::string& text) {
    constexpr long long most = 10000;
    if (text.empty()) return {};
    const std::size_t slash = std::min(text.find('/'), text.size());
    const auto part = parse_integer(std::string_view(text).substr(0, slash));
    const auto parts = parse_integer(std::string_view(text).substr(std::min(slash + 1, text.size())));
    if (!part || !parts || !(*part >= 1 && *part <= *parts && *parts <= most)) {
        throw InputError("--share " + shortened(text) + ": allowed K/N with 1 <= K <= N <= " + std::to_string(most));
    }
    return {static_cast<std::size_t>(*part), static_cast<std::size_t>(*parts)};
}

}  // namespace drape
