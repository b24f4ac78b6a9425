#include "drape/render/picture_size.h"

#include "drape/base/input_error.h"
#include "drape/base/numbers.h"

namespace drape {

PictureSize parse_size(const std::string& text) {
    const std::size_t by = text.find('x');
    const auto side = [&](const std::string& part) {
        const auto number = parse_integer(part);
        if (!number || *number < 1 || *number > 8192) {
            throw InputError("--size " + shortened(text) + ": allowed WxH, 1 to 8192 each");
        }
        return static_cast<int>(*number);
    };
    if (by == std::string::npos) return {side(text), side("")};
    return {side(text.substr(0, by)), side(text.substr(by + 1))};
}

}  // namespace drape
