#include "drape/sim/command.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "drape/base/input_error.h"
#include "drape/base/numbers.h"

namespace drape {
namespace {

/// A text that is all that is left of the line, blanks inside included; every other is one word.
template <class C>
struct LineMember {
    std::string C::*text;

    const std::string& operator()(const C& command) const { return command.*text; }
};
template <class C>
LineMember(std::string C::*) -> LineMember<C>;

/// A row of the table: how a command is written, its name first, and the members that its arguments fill, in order.
template <class C, class... Members>
struct Row {
    using Type = C;
    std::string_view form;
    std::tuple<Members...> members;

    [[nodiscard]] constexpr std::string_view name() const { return form.substr(0, form.find(' ')); }
};

template <class C, class... Members>
constexpr Row<C, Members...> row(std::string_view form, Members... members) {
    return {form, {members...}};
}

using namespace command;
constexpr std::tuple command_table{
    row<Pause>("pause"),
    row<Step>("step COUNT", &Step::count),
    row<Reset>("reset"),
    row<LoadScene>("scene NAME", LineMember{&LoadScene::name}),
    row<Load>("load FILE", LineMember{&Load::file}),
    row<Compare>("compare NAME=VALUE,... | none", LineMember{&Compare::assignments}),
    row<Set>("set NAME=VALUE", LineMember{&Set::assignment}),
    row<Next>("next SETTING", &Next::setting),
    row<Add>("add SETTING AMOUNT", &Add::setting, &Add::amount),
    row<Steer>("steer X Y Z", &Steer::direction),
    row<Throw>("throw X Y Z VX VY VZ", &Throw::from, &Throw::velocity),
    row<Fall>("fall"),
    row<Grab>("grab CLOTH PARTICLE", &Grab::cloth, &Grab::particle),
    row<Hold>("hold BALL", &Hold::ball),
    row<Drag>("drag X Y Z", &Drag::target),
    row<Release>("release"),
    row<Pin>("pin CLOTH PARTICLE", &Pin::cloth, &Pin::particle),
    row<Orbit>("orbit YAW PITCH", &Orbit::yaw, &Orbit::pitch),
    row<Pan>("pan RIGHT UP", &Pan::right, &Pan::up),
    row<Zoom>("zoom FACTOR", &Zoom::factor),
    row<Frame>("frame"),
    row<Home>("home"),
    row<Picture>("picture"),
    row<Video>("video"),
    row<Quit>("quit"),
};

template <class... Rows>
std::variant<typename Rows::Type...> commands_of(const std::tuple<Rows...>&);
static_assert(std::is_same_v<decltype(commands_of(command_table)), Command>,
              "every command has one row, in the same order");

/// Calls `look` with each row until it returns true.
template <class Look>
void find_row(Look look) {
    std::apply([&](const auto&... rows) { static_cast<void>((look(rows) || ...)); }, command_table);
}

/// The words of a command's text after its name, read one by one.
class Arguments {
public:
    Arguments(std::string_view form, std::string_view rest) : form_(form), rest_(rest) {}

    template <class C>
    void read(C& command, LineMember<C> member) {
        skip_blanks();
        if (rest_.empty()) refuse();
        command.*member.text = std::exchange(rest_, {});
    }

    template <class C, class Value>
    void read(C& command, Value C::*member) {
        read(command.*member);
    }

    void finish() {
        skip_blanks();
        if (!rest_.empty()) refuse();
    }

private:
    /// Lengths and angles beyond this are typing errors, and NaN is refused with them.
    static constexpr double largest = 1e9;

    void read(std::string& text) {
        skip_blanks();
        const std::size_t end = std::min(rest_.find_first_of(" \t"), rest_.size());
        if (end == 0) refuse();
        text = rest_.substr(0, end);
        rest_.remove_prefix(end);
    }

    void read(double& number) {
        std::string word;
        read(word);
        const auto value = parse_real(word);
        if (!value || !(*value >= -largest && *value <= largest)) refuse();
        number = *value;
    }

    void read(int& count) {
        std::string word;
        read(word);
        const auto value = parse_integer(word);
        if (!value || *value < 0 || *value > std::numeric_limits<int>::max()) refuse();
        count = static_cast<int>(*value);
    }

    void read(Vec3& vector) {
        for (int axis = 0; axis < 3; ++axis) {
            double number = 0;
            read(number);
            vector[axis] = static_cast<Real>(number);
        }
    }

    void skip_blanks() { rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t"), rest_.size())); }

    [[noreturn]] void refuse() const {
        throw InputError("command '" + std::string(form_.substr(0, form_.find(' '))) + "': expected '" +
                         std::string(form_) + "'");
    }

    std::string_view form_, rest_;
};

std::string text_of(const std::string& text) { return text; }
std::string text_of(double number) { return real_text(number); }
std::string text_of(int count) { return std::to_string(count); }
std::string text_of(const Vec3& v) {
    return text_of(static_cast<double>(v[0])) + " " + text_of(static_cast<double>(v[1])) + " " +
           text_of(static_cast<double>(v[2]));
}

}  // namespace

std::string command_text(const Command& command) {
    std::string text;
    find_row([&]<class C, class... Members>(const Row<C, Members...>& row) {
        const auto* found = std::get_if<C>(&command);
        if (found == nullptr) return false;
        text = row.name();
        std::apply([&](auto... members) { ((text += " " + text_of(std::invoke(members, *found))), ...); }, row.members);
        return true;
    });
    return text;
}

Command parse_command(std::string_view text) {
    const std::size_t end = std::min(text.find_first_of(" \t"), text.size());
    const std::string_view name = text.substr(0, end);
    std::optional<Command> found;
    std::vector<std::string> names;
    find_row([&]<class C, class... Members>(const Row<C, Members...>& row) {
        names.emplace_back(row.name());
        if (row.name() != name) return false;
        C command;
        Arguments arguments(row.form, text.substr(end));
        std::apply([&](auto... members) { (arguments.read(command, members), ...); }, row.members);
        arguments.finish();
        found = std::move(command);
        return true;
    });
    if (found) return *std::move(found);
    throw InputError("unknown command '" + shortened(name) + "'" + did_you_mean(name, names));
}

std::string_view setting_of(const Command& command) {
    if (const auto* next = std::get_if<command::Next>(&command)) return next->setting;
    if (const auto* add = std::get_if<command::Add>(&command)) return add->setting;
    const auto* set = std::get_if<command::Set>(&command);
    return set != nullptr ? std::string_view(set->assignment).substr(0, set->assignment.find('=')) : "";
}

bool changes_scene(const Command& command) {
    return std::holds_alternative<command::LoadScene>(command) || std::holds_alternative<command::Load>(command);
}

bool changes_state(const Command& command) {
    return std::visit([]<class C>(const C&) { return !command::OfThePicture<C>; }, command);
}

bool begins_again(const Command& command) {
    const auto* compare = std::get_if<command::Compare>(&command);
    return changes_scene(command) || std::holds_alternative<command::Reset>(command) ||
           (compare != nullptr && compare->begins());
}

bool pauses(const Command& command) {
    return std::holds_alternative<command::Pause>(command) || std::holds_alternative<command::Step>(command);
}

bool changes_motion(const Command& command) {
    if (pauses(command)) return false;
    if (const auto* compare = std::get_if<command::Compare>(&command)) return compare->begins();
    return changes_state(command) && !setting_of(command).starts_with("view.");
}

}  // namespace drape
