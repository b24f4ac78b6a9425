#include "drape/scene/scene.h"

// The parser's own assertions abort on bad input; without them it reports an error as it should.
#define TOML_HEADER_ONLY 1
#define TOML_ASSERT(condition) static_cast<void>(0)
#include <toml++/toml.h>

#include <algorithm>
#include <sstream>

#include "drape/base/input_error.h"
#include "drape/base/input_file.h"
#include "drape/base/resources.h"
#include "drape/scene/setting_table.h"

namespace drape {
namespace {

constexpr std::size_t largest_scene = 256 * 1024;
constexpr std::size_t longest_scene_line = 4 * 1024;

std::optional<double> number_of(const toml::node& node) {
    if (const auto* real = node.as_floating_point()) return real->get();
    if (const auto* integer = node.as_integer()) return static_cast<double>(integer->get());
    return std::nullopt;
}

/// The numbers of an array, or of its rows one after another where rows are wanted.
bool append_numbers(const toml::array& array, bool rows, std::vector<double>& values) {
    for (const toml::node& entry : array) {
        if (rows) {
            const toml::array* row = entry.as_array();
            if (row == nullptr || row->size() != 4 || !append_numbers(*row, false, values)) return false;
        } else {
            const auto number = number_of(entry);
            if (!number) return false;
            values.push_back(*number);
        }
    }
    return true;
}

/// A node's value in the form that a kind of setting has, or in its own; nothing if it has none that a setting could.
std::optional<SettingValue> toml_value(const toml::node& node, SettingKind kind) {
    if (const auto* flag = node.as_boolean()) {
        if (kind == SettingKind::Choice) return std::string(flag->get() ? "true" : "false");
        return flag->get();
    }
    if (const auto number = number_of(node)) return *number;
    if (const auto* text = node.as_string()) return text->get();
    std::vector<double> values;
    const toml::array* array = node.as_array();
    if (array == nullptr || !append_numbers(*array, kind == SettingKind::Path, values)) return std::nullopt;
    return values;
}

/// The node as it might stand in a file, shortened, for messages.
std::string toml_text(const toml::node& node) {
    if (node.is_table()) return "a table";
    std::ostringstream out;
    out.imbue(std::locale::classic());
    out << toml::default_formatter(node);
    return shortened(out.str());
}

/// Reads a scene into settings.
class SceneReader {
public:
    explicit SceneReader(std::string file) : file_(std::move(file)) {}

    Settings read(std::string_view text) {
        const toml::table root = parsed(text);
        if (root.get("cloth") == nullptr) throw InputError(file_ + ": [cloth] is missing: a scene needs one");
        settings_.cloths.clear();
        for (const auto& [key, node] : root) read_top(std::string(key.str()), node);
        try {
            check(settings_);
        } catch (const InconsistentSettings& misfit) {
            fail(node_of(misfit, *root.get(misfit.section)), misfit.what());
        }
        return std::move(settings_);
    }

private:
    [[nodiscard]] toml::table parsed(std::string_view text) const {
        try {
            return toml::parse(text, file_);
        } catch (const toml::parse_error& error) {
            fail(error.source(), std::string(error.description()));
        }
    }

    /// The setting that does not fit the others, or the table that should have it.
    static const toml::node& node_of(const InconsistentSettings& misfit, const toml::node& section) {
        const toml::array* several = section.as_array();
        const toml::node& table = several != nullptr ? *several->get(misfit.index) : section;
        const toml::node* setting = table.as_table()->get(misfit.name);
        return setting != nullptr ? *setting : table;
    }

    void read_top(const std::string& name, const toml::node& node) {
        if (name == "title" || name == "start") return write(node, find_setting(name), 0);
        const auto row = std::ranges::find(setting_table(), name, &Setting::section);
        if (row == setting_table().end()) refuse_unknown(node, name, "");
        row->several != nullptr ? read_several(node, *row) : read_section(table_of(node, name), name, "", 0);
    }

    /// `[cloth]` or `[[cloth]]`
    void read_several(const toml::node& node, const Setting& row) {
        const std::string& name = row.section;
        const toml::array* several = node.as_array();
        const std::size_t count = several != nullptr ? several->size() : 1;
        if (count == 0 || count > max_entries) {
            fail(node, name + ": allowed 1 to " + std::to_string(max_entries) + " of them");
        }
        for (std::size_t i = 0; i < count; ++i) {
            const toml::node& one = several != nullptr ? *several->get(i) : node;
            row.several->add(settings_);
            const toml::table& table = table_of(one, name);
            if (table.contains("origin") && table.contains("centre")) {
                fail(*table.get("centre"), name + ".centre: allowed only without " + name + ".origin");
            }
            read_section(table, name, "", i);
        }
    }

    /// @param prefix of the names within the section, as in "structural."
    void read_section(const toml::table& table, const std::string& section, const std::string& prefix,
                      std::size_t index) {
        for (const auto& [key, node] : table) {
            const std::string name = prefix + std::string(key.str());
            const Setting* row = nullptr;
            bool is_group = false;
            for (const Setting& setting : setting_table()) {
                if (setting.section != section) continue;
                if (setting.name == name) row = &setting;
                is_group = is_group || setting.name.starts_with(name + ".");
            }
            if (row != nullptr) {
                write(node, *row, index);
            } else if (is_group) {
                read_section(table_of(node, section + "." + name), section, name + ".", index);
            } else {
                refuse_unknown(node, section + "." + name, section);
            }
        }
    }

    void write(const toml::node& node, const Setting& setting, std::size_t index) {
        const auto value = toml_value(node, setting.kind);
        const std::string name = setting.full_name();
        if (!value || !refusal(setting, *value).empty()) {
            // A text has its quotes, lest it be taken for a number
            const std::string shown = value && !node.is_string() ? shortened(value_text(*value)) : toml_text(node);
            fail(node, name + " = " + shown + ": allowed " + accepted(setting));
        }
        setting.write(settings_, index, *value);
        if (name == "start") find_file(node, name, settings_.start);
        if (name == "solid.file") find_file(node, name, settings_.solids[index].file);
    }

    /// A scene of somebody else's is to read no files but those that came with it.
    void find_file(const toml::node& node, const std::string& name, std::string& file) {
        if (file.empty()) return;
        const std::filesystem::path folder = std::filesystem::path(file_).parent_path(), path = folder / file;
        std::error_code none;
        const auto base = std::filesystem::weakly_canonical(absolute(folder.empty() ? "." : folder), none);
        const auto relative = std::filesystem::weakly_canonical(absolute(path), none).lexically_relative(base);
        if (none || relative.empty() || *relative.begin() == "..") {
            fail(node, name + " = " + toml_text(node) + ": allowed only a file in the scene's folder or below");
        }
        file = path.string();
    }

    const toml::table& table_of(const toml::node& node, const std::string& name) {
        if (!node.is_table())
            fail(node,
                 shortened(name) + " = " + toml_text(node) + ": allowed only a table, as in [" + shortened(name) + "]");
        return *node.as_table();
    }

    [[noreturn]] void refuse_unknown(const toml::node& node, const std::string& name, const std::string& section) {
        std::vector<std::string> names;
        for (const Setting& setting : setting_table()) {
            if (section.empty()) {
                names.push_back(setting.section.empty() ? setting.name : setting.section);
            } else if (setting.section == section) {
                names.push_back(setting.full_name());
            }
        }
        fail(node,
             "unknown key '" + shortened(name) + "'" + did_you_mean(name, names, ": drape-lab list settings has all"));
    }

    [[noreturn]] void fail(const toml::node& node, const std::string& message) const { fail(node.source(), message); }

    [[noreturn]] void fail(const toml::source_region& place, const std::string& message) const {
        throw InputError(file_ + ":" + std::to_string(place.begin.line) + ":" + std::to_string(place.begin.column) +
                         ": " + message);
    }

    static constexpr std::size_t max_entries = 64;

    std::string file_;
    Settings settings_;
};

/// Refuses what the parser was not made for, before it sees it.
void check_sizes(std::string_view text, const std::string& file) {
    if (text.size() > largest_scene) {
        throw InputError(file + ": " + std::to_string(text.size()) + " bytes: allowed at most " +
                         std::to_string(largest_scene));
    }
    std::size_t line = 1;
    for (std::size_t begin = 0; begin < text.size(); ++line) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        if (end - begin > longest_scene_line) {
            throw InputError(file + ":" + std::to_string(line) + ":1: a line of " + std::to_string(end - begin) +
                             " bytes: allowed at most " + std::to_string(longest_scene_line));
        }
        begin = end + 1;
    }
}

}  // namespace

Settings parse_scene(std::string_view text, const std::string& file) {
    check_sizes(text, file);
    return SceneReader(file).read(text);
}

std::filesystem::path scene_file(const std::string& name_or_path) {
    const bool is_path = name_or_path.find('/') != std::string::npos || name_or_path.ends_with(".toml");
    if (is_path) return name_or_path;
    const auto names = scene_names();
    if (std::ranges::find(names, name_or_path) == names.end()) {
        throw InputError("scene '" + shortened(name_or_path) + "': allowed " + listed(names) +
                         ", or the path of a .toml file" + did_you_mean(name_or_path, names));
    }
    return find_resource("scenes/" + name_or_path + ".toml");
}

Settings load_scene(const std::string& name_or_path) {
    const std::string path = scene_file(name_or_path).string();
    return parse_scene(read_text(path, largest_scene), path);
}

std::vector<std::string> scene_names() {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(find_resource("scenes"))) {
        if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
    }
    const auto rank = [](const std::string& name) {
        return name == "veil" ? 0 : name == "drop" ? 1 : name.starts_with("fails_") ? 3 : 2;
    };
    std::ranges::sort(names, {}, [&](const std::string& name) { return std::pair(rank(name), name); });
    return names;
}

}  // namespace drape
