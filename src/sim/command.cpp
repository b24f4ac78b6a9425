#include "drape/sim/command.h"

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include "drape/base/input_error.h"
#include "drape/base/numbers.h"

namespace drape {
namespace {

/// The words of a command's text after its name, read one by one.
class Arguments {
public:
    Arguments(std::string_view name, std::string_view form, std::string_view rest)
        : name_(name), form_(form), rest_(rest) {}

    std::string word() {
        skip_blanks();
        const std::size_t end = std::min(rest_.find_first_of(" \t"), rest_.size());
        if (end == 0) refuse();
        std::string text(rest_.substr(0, end));
        rest_.remove_prefix(end);
        return text;
    }

    /// All that is left, blanks inside included.
    std::string line() {
        skip_blanks();
        if (rest_.empty()) refuse();
        return std::string(std::exchange(rest_, {}));
    }

    double number() {
        const auto value = parse_real(word());
        if (!value || !(*value >= -largest && *value <= largest)) refuse();
        return *value;
    }

    int count() {
        const auto value = parse_integer(word());
        if (!value || *value < 0 || *value > std::numeric_limits<int>::max()) refuse();
        return static_cast<int>(*value);
    }

    Vec3 vector() {
        const double x = number(), y = number(), z = number();
        return {static_cast<Real>(x), static_cast<Real>(y), static_cast<Real>(z)};
    }

    void finish() {
        skip_blanks();
        if (!rest_.empty()) refuse();
    }

private:
    /// Lengths and angles beyond this are typing errors, and NaN is refused with them.
    static constexpr double largest = 1e9;

    void skip_blanks() { rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t"), rest_.size())); }

    [[noreturn]] void refuse() const {
        throw InputError("command '" + std::string(name_) + "': expected '" + std::string(form_) + "'");
    }

    std::string_view name_, form_, rest_;
};

/// A command's name, its form for messages, and how its arguments are read.
struct Form {
    std::string name;
    std::string form;
    std::function<Command(Arguments&)> read;
};

const std::vector<Form>& forms() {
    using namespace command;
    static const std::vector<Form> all{
        {"pause", "pause", [](Arguments&) { return Pause{}; }},
        {"step", "step COUNT", [](Arguments& a) { return Step{a.count()}; }},
        {"reset", "reset", [](Arguments&) { return Reset{}; }},
        {"scene", "scene NAME", [](Arguments& a) { return LoadScene{a.line()}; }},
        {"set", "set NAME=VALUE", [](Arguments& a) { return Set{a.line()}; }},
        {"next", "next SETTING", [](Arguments& a) { return Next{a.word()}; }},
        {"add", "add SETTING AMOUNT",
         [](Arguments& a) {
             std::string setting = a.word();
             return Add{std::move(setting), a.number()};
         }},
        {"steer", "steer X Y Z", [](Arguments& a) { return Steer{a.vector()}; }},
        {"grab", "grab CLOTH PARTICLE",
         [](Arguments& a) {
             const int cloth = a.count();
             return Grab{cloth, a.count()};
         }},
        {"drag", "drag X Y Z", [](Arguments& a) { return Drag{a.vector()}; }},
        {"release", "release", [](Arguments&) { return Release{}; }},
        {"orbit", "orbit YAW PITCH",
         [](Arguments& a) {
             const double yaw = a.number();
             return Orbit{yaw, a.number()};
         }},
        {"pan", "pan RIGHT UP",
         [](Arguments& a) {
             const double right = a.number();
             return Pan{right, a.number()};
         }},
        {"zoom", "zoom FACTOR", [](Arguments& a) { return Zoom{a.number()}; }},
        {"frame", "frame", [](Arguments&) { return Frame{}; }},
        {"picture", "picture", [](Arguments&) { return Picture{}; }},
        {"quit", "quit", [](Arguments&) { return Quit{}; }},
    };
    return all;
}

std::string vector_text(const Vec3& v) {
    return real_text(static_cast<double>(v[0])) + " " + real_text(static_cast<double>(v[1])) + " " +
           real_text(static_cast<double>(v[2]));
}

/// The text after the name, one overload a command that has arguments.
struct ArgumentText {
    std::string operator()(const command::Step& c) const { return " " + std::to_string(c.count); }
    std::string operator()(const command::LoadScene& c) const { return " " + c.name; }
    std::string operator()(const command::Set& c) const { return " " + c.assignment; }
    std::string operator()(const command::Next& c) const { return " " + c.setting; }
    std::string operator()(const command::Add& c) const { return " " + c.setting + " " + real_text(c.amount); }
    std::string operator()(const command::Steer& c) const { return " " + vector_text(c.direction); }
    std::string operator()(const command::Grab& c) const {
        return " " + std::to_string(c.cloth) + " " + std::to_string(c.particle);
    }
    std::string operator()(const command::Drag& c) const { return " " + vector_text(c.target); }
    std::string operator()(const command::Orbit& c) const { return " " + real_text(c.yaw) + " " + real_text(c.pitch); }
    std::string operator()(const command::Pan& c) const { return " " + real_text(c.right) + " " + real_text(c.up); }
    std::string operator()(const command::Zoom& c) const { return " " + real_text(c.factor); }
    template <class WithoutArguments>
    std::string operator()(const WithoutArguments&) const {
        return {};
    }
};

}  // namespace

// The forms stand in the order of the variant's alternatives.
std::string command_text(const Command& command) {
    return forms()[command.index()].name + std::visit(ArgumentText{}, command);
}

Command parse_command(std::string_view text) {
    const std::size_t end = std::min(text.find_first_of(" \t"), text.size());
    const std::string_view name = text.substr(0, end);
    for (const Form& form : forms()) {
        if (form.name != name) continue;
        Arguments arguments(name, form.form, text.substr(end));
        Command command = form.read(arguments);
        arguments.finish();
        return command;
    }
    std::vector<std::string> names;
    for (const Form& form : forms()) names.push_back(form.name);
    throw InputError("unknown command '" + shortened(name) + "': did you mean '" + nearest_name(name, names) + "'?");
}

bool changes_state(const Command& command) {
    return std::visit(
        []<class C>(const C&) {
            using namespace drape::command;
            return !(std::is_same_v<C, Orbit> || std::is_same_v<C, Pan> || std::is_same_v<C, Zoom> ||
                     std::is_same_v<C, Frame> || std::is_same_v<C, Picture> || std::is_same_v<C, Quit>);
        },
        command);
}

}  // namespace drape
