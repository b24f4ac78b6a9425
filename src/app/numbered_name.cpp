#include "numbered_name.h"

namespace drape {

std::filesystem::path numbered_name(int number, const std::string& extension) {
    std::string digits = std::to_string(number);
    if (digits.size() < 4) digits.insert(0, 4 - digits.size(), '0');
    return "drape-" + digits + extension;
}

}  // namespace drape
