#pragma once

#include <algorithm>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace drape {

/// Texts for the user that go away by themselves.
class Notices {
public:
    /// Shows a text for a few seconds.
    /// @param topic a text takes the place of the one before it on the same topic
    void add(const std::string& topic, const std::string& text) {
        constexpr double shown_for = 5;  // s
        remove(topic);
        notices_.push_back({topic, text, shown_for});
    }

    /// Takes the text on a topic away, if there is one.
    void remove(const std::string& topic) {
        std::erase_if(notices_, [&](const Notice& notice) { return notice.topic == topic; });
    }

    /// Takes all texts away but those on some topics.
    void keep_only(std::initializer_list<std::string_view> topics) {
        std::erase_if(notices_, [&](const Notice& notice) { return std::ranges::count(topics, notice.topic) == 0; });
    }

    /// Whether there is a text on a topic.
    [[nodiscard]] bool shows(std::string_view topic) const {
        return std::ranges::find(notices_, topic, &Notice::topic) != notices_.end();
    }

    /// Lets time pass. @return whether a text went away
    bool advance(double elapsed) {
        for (Notice& notice : notices_) notice.left -= elapsed;
        return std::erase_if(notices_, [](const Notice& notice) { return notice.left <= 0; }) > 0;
    }

    /// All texts, the oldest first, after `lasting`, if that says anything.
    [[nodiscard]] std::vector<std::string> texts(const std::string& lasting) const {
        std::vector<std::string> texts;
        if (!lasting.empty()) texts.push_back(lasting);
        for (const Notice& notice : notices_) texts.push_back(notice.text);
        return texts;
    }

private:
    struct Notice {
        std::string topic;
        std::string text;
        double left;  ///< [s]
    };
    std::vector<Notice> notices_;
};

}  // namespace drape
