#pragma once

#include <string>
#include <vector>

namespace drape {

/// Lines for the user that go away by themselves.
class Notices {
public:
    /// Shows a text for a few seconds.
    /// @param topic a text takes the place of the one before it on the same topic
    void add(const std::string& topic, const std::string& text);

    /// Takes the text on a topic away, if there is one.
    void remove(const std::string& topic);

    /// Lets time pass. @return whether a text went away
    bool advance(double elapsed);

    /// The lines of all texts, the oldest first, after those of `lasting`.
    [[nodiscard]] std::vector<std::string> lines(const std::string& lasting) const;

private:
    struct Notice {
        std::string topic;
        std::string text;
        double left;  ///< [s]
    };
    std::vector<Notice> notices_;
};

}  // namespace drape
