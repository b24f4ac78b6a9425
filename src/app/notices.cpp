#include "notices.h"

#include <sstream>

namespace drape {

void Notices::add(const std::string& topic, const std::string& text) {
    constexpr double shown_for = 5;  // s
    remove(topic);
    notices_.push_back({topic, text, shown_for});
}

void Notices::remove(const std::string& topic) {
    std::erase_if(notices_, [&](const Notice& notice) { return notice.topic == topic; });
}

bool Notices::advance(double elapsed) {
    for (Notice& notice : notices_) notice.left -= elapsed;
    return std::erase_if(notices_, [](const Notice& notice) { return notice.left <= 0; }) > 0;
}

std::vector<std::string> Notices::lines(const std::string& lasting) const {
    std::vector<std::string> lines;
    const auto append = [&](const std::string& text) {
        std::istringstream in(text);
        for (std::string line; std::getline(in, line);) lines.push_back(line);
    };
    append(lasting);
    for (const Notice& notice : notices_) append(notice.text);
    return lines;
}

}  // namespace drape
