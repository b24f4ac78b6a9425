#include "menu_panel.h"

#include <imgui.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <sstream>
#include <tuple>
#include <utility>

namespace drape {

namespace {

constexpr float menu_columns = 58, menu_rows = 30;      // where there is room [font size], rows
constexpr float group_columns = 14, mark_columns = 15;  // [font size]
constexpr float help_rows = 3;                          // that the longest help of a setting takes

std::string small_letters(std::string text) {
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

// How well a text has the query: as a word of its own, from where a word begins, within a word, not at all
int rank_of(std::string_view text, std::string_view query) {
    const auto is_letter = [&](std::size_t k) {
        return k < text.size() && std::isalnum(static_cast<unsigned char>(text[k])) != 0;
    };
    int best = 3;
    for (std::size_t at = text.find(query); at != text.npos; at = text.find(query, at + 1)) {
        const bool begins = at == 0 || !is_letter(at - 1);
        best = std::min(best, !begins ? 2 : is_letter(at + query.size()) ? 1 : 0);
    }
    return best;
}

}  // namespace

void MenuPanel::open(std::span<const Entry> entries, const Settings& settings) {
    items_.clear();
    for (const Entry& entry : entries) {
        const std::string keys = key_text(entry), group = entry.menu.empty() ? "General" : entry.menu;
        const std::string searched = entry.text + " " + group + " " + keys + " " + entry.command;
        items_.push_back({group, entry.text, keys, small_letters(searched), MenuMark(entry)});
    }
    for (const Setting& setting : setting_table()) {
        if (!has_panel_row(setting) || section_count(settings, setting) == 0) continue;
        const std::string name = setting.full_name();
        const std::string searched = name + " " + setting_label(setting) + " setting " + setting.help;
        const bool is_idle = !why_without_effect(setting, settings, 0).empty();
        items_.push_back({"Settings", name, "", small_letters(searched), {}, &setting, is_idle});
    }
    query_.clear();
    search();
    open_ = moved_ = true;
}

void MenuPanel::type(unsigned char code) {
    constexpr unsigned char erase = 8, enter = 13, next = 14, previous = 16, escape = 27;
    if (code == enter) return choose();
    open_ = code != escape;
    moved_ = true;
    if (code == next && row_ + 1 < found_.size()) ++row_;
    if (code == previous && row_ > 0) --row_;
    if (code == next || code == previous) return;
    if (code == erase && !query_.empty()) query_.pop_back();
    const bool opens = code == '/' && query_.empty();  // the key still repeats
    const bool is_letter = code >= ' ' && code < 127 && !opens && query_.size() < 60;
    if (is_letter) query_ = small_letters(query_ + static_cast<char>(code));
    search();
}

void MenuPanel::search() {
    // What is called so or has this key, then what has the query in its name, whole words first, the sooner the better;
    // last what has no effect now
    const auto place = [this](std::size_t k) {
        const std::string text = small_letters(items_[k].text), keys = ", " + small_letters(items_[k].keys) + ", ";
        const Setting* setting = items_[k].setting;
        const bool is_label =
            setting != nullptr && !items_[k].is_idle && small_letters(setting_label(*setting)) == query_;
        const bool is_it = text == query_ || is_label || keys.find(", " + key_name(query_) + ", ") != std::string::npos;
        return std::tuple(!is_it, items_[k].is_idle, rank_of(text, query_), text.find(query_));
    };
    found_.clear();
    for (std::size_t k = 0; k < items_.size(); ++k) {
        std::istringstream words(query_);
        bool fits = true;
        for (std::string word; fits && words >> word;) {
            fits = items_[k].searched.find(key_name(word)) != std::string::npos;
        }
        if (fits) found_.push_back(k);
    }
    if (!query_.empty()) std::ranges::stable_sort(found_, {}, place);
    row_ = 0;
}

void MenuPanel::choose() {
    if (row_ >= found_.size()) return;
    open_ = false;
    const Setting* setting = items_[found_[row_]].setting;
    setting != nullptr ? settings_.show(*setting) : void(wishes_.entry = found_[row_]);
}

void MenuPanel::draw(const FrameView& view, const OverlayPage& page) {
    if (!open_) return;
    const float size = ImGui::GetFontSize(), row = ImGui::GetTextLineHeightWithSpacing(), pad = 0.8f * size;
    const float width = std::min(menu_columns * size, page.width - 2 * page.margin);
    const float height = std::min(menu_rows * row, page.height - 2 * page.margin);
    const float left = (page.width - width) / 2, top = (page.height - height) / 2;
    const PanelBox box{left, top, left + width, top + height};
    ImGui::SetNextWindowBgAlpha(0.96f);
    if (begin_window(box, "menu", ImGuiWindowFlags_NoDecoration, 0)) {
        // The field, with a mark where the next character comes
        const ImVec2 field{left + pad, top + pad}, far{box.right - pad, field.y + 1.8f * size};
        ImGui::GetWindowDrawList()->AddRectFilled(field, far, ink::groove, 3);
        const ImVec2 text{field.x + 0.5f * size, field.y + 0.4f * size};
        text_at(text, ink::text, query_ + "|");
        const char* what = "Search entries, keys, scenes and settings; Up, Down, Enter, Esc";
        if (query_.empty()) text_at({text.x + size, text.y}, ink::quiet, what);

        // As many rows as are whole, also where it is scrolled, and below them what the setting does
        const float top_row = far.y + 0.4f * size;
        const float shown = std::max(1.0f, std::floor((box.bottom - pad - (help_rows + 0.3f) * row - top_row) / row));
        ImGui::SetCursorScreenPos({field.x, top_row});
        ImGui::BeginChild("found", {width - 2 * pad, shown * row});
        if (found_.empty()) text_at({field.x, top_row}, ink::quiet, "Nothing found");
        ImGui::SetScrollY(row * std::round(ImGui::GetScrollY() / row));
        for (std::size_t k = 0; k < found_.size() && open_; ++k) draw_row(k, view);
        ImGui::Dummy({0, 0});  // the gap below the last row
        ImGui::EndChild();

        const Setting* setting = row_ < found_.size() ? items_[found_[row_]].setting : nullptr;
        ImGui::PushTextWrapPos(far.x - left);
        if (setting != nullptr) text_at({field.x, box.bottom - pad - help_rows * row}, ink::quiet, setting->help);
        ImGui::PopTextWrapPos();
    }
    end_window();
    const ImVec2 pointer = ImGui::GetIO().MousePos;
    if (ImGui::IsMouseClicked(ImGuiMouseButton_Left) && !box.covers(pointer.x, pointer.y)) open_ = false;
}

void MenuPanel::draw_row(std::size_t row, const FrameView& view) {
    const Item& item = items_[found_[row]];
    const float size = ImGui::GetFontSize(), end = ImGui::GetContentRegionMax().x + ImGui::GetWindowPos().x - size;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::PushID(static_cast<int>(row));
    if (ImGui::Selectable("##row", row == row_)) row_ = row, choose();
    ImGui::PopID();
    if (row == row_ && std::exchange(moved_, false)) ImGui::SetScrollHereY();

    const auto write = [&](float x, ImU32 colour, std::string_view text) {
        ImGui::GetWindowDrawList()->AddText({x, corner.y}, colour, text.data(), text.data() + text.size());
    };
    if (row == 0 || items_[found_[row - 1]].group != item.group) write(corner.x, ink::quiet, item.group);
    std::string mark = item.mark.text(*view.settings, view.scene, view.paused);
    // Another scene may have come, without such a section
    if (item.setting != nullptr && section_count(*view.settings, *item.setting) > 0) {
        mark = shown_value(*item.setting, item.setting->read(*view.settings, 0));
    }
    const float text_end = end - (mark.empty() ? text_width(item.keys) + size : mark_columns * size);
    ImGui::PushClipRect(corner, {text_end, corner.y + 2 * size}, true);
    write(corner.x + group_columns * size, ink::text, item.text);
    ImGui::PopClipRect();
    write(end - mark_columns * size + size, ink::good, mark);
    write(end - text_width(item.keys), ink::wait, item.keys);
}

}  // namespace drape
