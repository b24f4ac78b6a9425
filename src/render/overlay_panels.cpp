#include "overlay_panels.h"

#include <imgui.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <utility>

#include "colour_panel.h"
#include "figures_panel.h"
#include "overlay_style.h"

namespace drape {

namespace {

constexpr std::array<float, 8> font_sizes{11, 14, 17, 22, 28, 36, 46, 60};  // pixel

// Below this nothing could be read
constexpr int least_width = 120, least_height = 60;

constexpr ImGuiWindowFlags window_flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoBackground |
                                          ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoNav |
                                          ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoMove;

void add_fonts(std::array<ImFont*, font_sizes.size()>& fonts) {
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    const std::filesystem::path file = DRAPE_FONT;
    std::error_code ignored;
    const bool found = std::filesystem::is_regular_file(file, ignored);
    for (std::size_t i = 0; i < fonts.size(); ++i) {
        if (found) {
            fonts[i] = atlas.AddFontFromFileTTF(file.c_str(), font_sizes[i]);
        } else {
            ImFontConfig config;
            config.SizePixels = font_sizes[i];
            fonts[i] = atlas.AddFontDefault(&config);
        }
    }
    atlas.Build();
}

// The largest font that is not larger than a window of that size should have; one more is left for titles
std::size_t font_for(int width, int height, double scale) {
    const int side = std::min(height, 2 * width / 3);
    const double wanted = scale * (side < 600 ? 11 : side < 1000 ? 14 : side < 1300 ? 17 : side < 1800 ? 22 : 28);
    std::size_t size = 0;
    while (size + 2 < font_sizes.size() && static_cast<double>(font_sizes[size + 1]) <= wanted) ++size;
    return size;
}

void set_style() {
    ImGuiStyle& style = ImGui::GetStyle();
    ImGui::StyleColorsDark();
    style.WindowBorderSize = 0;
    style.WindowMinSize = {1, 1};
    style.WindowPadding = {0, 0};
    style.ItemSpacing = {6, 2};
    style.FramePadding = {6, 1};
    style.FrameRounding = 3;
    style.ScrollbarSize = 10;
    style.Colors[ImGuiCol_FrameBg] = ImGui::ColorConvertU32ToFloat4(ink::groove);
    style.Colors[ImGuiCol_SliderGrab] = ImGui::ColorConvertU32ToFloat4(ink::bar);
    style.Colors[ImGuiCol_PopupBg] = ImGui::ColorConvertU32ToFloat4(ink::popup);
    for (const ImGuiCol part : {ImGuiCol_Header, ImGuiCol_Button}) {
        style.Colors[part] = ImGui::ColorConvertU32ToFloat4(ink::groove);
        for (const int state : {1, 2}) style.Colors[part + state] = ImGui::ColorConvertU32ToFloat4(ink::lit);
    }
    for (const ImGuiCol part : {ImGuiCol_FrameBgHovered, ImGuiCol_FrameBgActive}) {
        style.Colors[part] = ImGui::ColorConvertU32ToFloat4(ink::lit);
    }
    style.Colors[ImGuiCol_SliderGrabActive] = ImGui::ColorConvertU32ToFloat4(ink::wait);
    style.Colors[ImGuiCol_CheckMark] = ImGui::ColorConvertU32ToFloat4(ink::bar);
}

// The keys of a text field, by the character that they make
constexpr std::array<std::pair<ImGuiKey, unsigned char>, 3> field_keys{
    {{ImGuiKey_Backspace, 8}, {ImGuiKey_Enter, 13}, {ImGuiKey_Escape, 27}}};

// Where the texts of keys start beside them
struct KeyColumns {
    float texts_from = 0, texts = 0;
    [[nodiscard]] float width() const { return texts_from + texts; }
};

KeyColumns columns_of(std::span<const KeyHelp> lines) {
    KeyColumns columns;
    for (const KeyHelp& line : lines) {
        columns.texts_from = std::max(columns.texts_from, ImGui::CalcTextSize(line.key.c_str()).x);
        columns.texts = std::max(columns.texts, ImGui::CalcTextSize(line.text.c_str()).x);
    }
    columns.texts_from += ImGui::GetFontSize();
    return columns;
}

void key_panel(std::span<const KeyHelp> lines, const KeyColumns& columns, float row, ImVec2 corner, float width,
               float margin) {
    draw_panel(corner, {width, static_cast<float>(lines.size()) * row + 2 * margin});
    corner = {corner.x + margin, corner.y + margin};
    for (const KeyHelp& line : lines) {
        text_at(corner, ink::wait, line.key.c_str());
        text_at({corner.x + columns.texts_from, corner.y}, ink::text, line.text.c_str());
        corner.y += row;
    }
}

// The room between panels at both sides
struct Between {
    float left, right;
    [[nodiscard]] float middle() const { return (left + right) / 2; }
    [[nodiscard]] float width() const { return right - left; }
};

// At the top where there is room for it beside the others, else at the bottom
void notice_panel(std::span<const std::string> notices, Between room, const OverlayPage& page) {
    const bool at_top = room.width() > 20 * ImGui::GetFontSize();
    if (!at_top) room = {page.margin, page.width - page.margin};
    const float most = room.width() - 2 * page.margin;
    ImVec2 size{0, 0};
    for (const std::string& notice : notices) {
        const ImVec2 part = ImGui::CalcTextSize(notice.c_str(), nullptr, false, most);
        size = {std::max(size.x, part.x), size.y + part.y};
    }
    const ImVec2 panel{size.x + 2 * page.margin, std::min(size.y + 2 * page.margin, page.height - 2 * page.margin)};
    const float top = at_top ? page.margin : page.height - panel.y - page.margin;
    const ImVec2 corner{room.middle() - panel.x / 2, top};
    draw_panel(corner, panel);

    ImVec2 line{corner.x + page.margin, corner.y + page.margin};
    ImGui::PushTextWrapPos(line.x + most + 1);
    for (const std::string& notice : notices) {
        text_at(line, ink::wait, notice.c_str());
        line.y += ImGui::CalcTextSize(notice.c_str(), nullptr, false, most).y;
    }
    ImGui::PopTextWrapPos();
}

}  // namespace

void OverlayPanels::DestroyContext::operator()(ImGuiContext* context) const { ImGui::DestroyContext(context); }

OverlayPanels::OverlayPanels() {
    IMGUI_CHECKVERSION();
    context_.reset(ImGui::CreateContext());
    ImGui::SetCurrentContext(context_.get());
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.LogFilename = nullptr;
    io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
    for (const auto& [key, code] : field_keys) io.KeyMap[key] = code;
    set_style();
    add_fonts(fonts_);
}

void OverlayPanels::point(const PanelPointer& pointer) {
    std::vector<PanelPointer>& next = input_.next;
    const bool was_down = next.size() > 1 ? next[next.size() - 2].down : input_.seen.down;
    const bool only_moved = !next.empty() && next.back().down == pointer.down && was_down == pointer.down;
    if (!only_moved) {
        next.push_back(pointer);
        return;
    }
    const int notches = next.back().notches + pointer.notches;
    next.back() = pointer;
    next.back().notches = notches;
}

void OverlayPanels::type(unsigned char code) { input_.typed += static_cast<char>(code); }

bool OverlayPanels::have_pointer() const {
    ImGui::SetCurrentContext(context_.get());
    const PanelPointer& pointer = input_.last();
    return settings.covers(static_cast<float>(pointer.x), static_cast<float>(pointer.y)) ||
           (settings.left() > 0 && ImGui::GetIO().WantCaptureMouse);
}

bool OverlayPanels::have_keyboard() const {
    ImGui::SetCurrentContext(context_.get());
    return settings.left() > 0 && ImGui::GetIO().WantTextInput;
}

void OverlayPanels::hide_settings() {
    settings.hide();
    input_ = {};
}

void OverlayPanels::hand_over_input() {
    ImGuiIO& io = ImGui::GetIO();
    const bool was_down = input_.seen.down;
    input_.seen.notches = 0;
    if (!input_.next.empty()) {
        input_.seen = input_.next.front();
        input_.next.erase(input_.next.begin());
    }
    io.MousePos = {static_cast<float>(input_.seen.x), static_cast<float>(input_.seen.y)};
    io.MouseDown[0] = input_.seen.down;
    io.MouseWheel = static_cast<float>(input_.seen.notches);
    io.KeyCtrl = input_.seen.control && input_.seen.down && !was_down;

    // Characters up to the next key that makes none, and of those one in every other frame
    for (const auto& [key, code] : field_keys) io.KeysDown[code] = false;
    while (!input_.typed.empty() && static_cast<unsigned char>(input_.typed.front()) >= ' ') {
        io.AddInputCharacter(static_cast<unsigned char>(input_.typed.front()));
        input_.typed.erase(input_.typed.begin());
    }
    input_.key_seen = !input_.key_seen && !input_.typed.empty();
    if (!input_.key_seen) return;
    io.KeysDown[static_cast<unsigned char>(input_.typed.front())] = true;
    input_.typed.erase(input_.typed.begin());
}

bool OverlayPanels::build(const FrameView& view, const Camera& camera, const FrameReport& last,
                          std::span<const std::string> notices, int width, int height) {
    const ViewSettings& shown = view.settings->view;
    plots_.keep(view);
    const bool showing_help = shown.help && !help.empty();
    const bool showing_panel = shown.panel != PanelSize::Off;
    const bool names_nodes = shown.bounds && hover_x >= 0;
    const bool nothing = !showing_panel && !showing_help && notices.empty() && hint.empty() && !shown.controls;
    if (width < least_width || height < least_height || (nothing && !shown.plots && !names_nodes)) {
        hide_settings();
        return false;
    }

    ImGui::SetCurrentContext(context_.get());
    const auto w = static_cast<float>(width), h = static_cast<float>(height);
    ImGui::GetIO().DisplaySize = {w, h};
    ImGui::GetIO().DeltaTime = 1.0f / 60;
    const std::size_t size = font_for(width, height, shown.text_scale);
    const float margin = size == 0 ? 8.0f : std::max(12.0f, 0.7f * font_sizes[size]);

    hand_over_input();
    ImGui::NewFrame();
    ImGui::PushFont(fonts_[size]);
    ImGui::SetNextWindowPos({0, 0});
    ImGui::SetNextWindowSize({w, h});
    ImGui::Begin("overlay", nullptr, window_flags);
    OverlayPage page{w, h, margin};
    if (shown.plots) page.height -= plots_.draw(page);
    Between room{margin, settings.left() > 0 ? settings.left() - margin : w - margin};
    const float right = room.right;
    float legends_left = right;
    if (showing_panel) room.left = figures_panel(view, last, fonts_[size + 1], page) + margin;
    if (showing_help) {
        room.right = help_panel(page, room.left) - margin;
    } else if (showing_panel) {
        legends(view, room.left - margin, {right + margin, page.height, margin});
        // As wide as the wider of them
        if (shown.bounds || colours.by != ColourBy::Plain) legends_left -= 32 * ImGui::GetFontSize();
    }
    if (!hint.empty() && !showing_help) hint_panel(page, legends_left);
    if (!notices.empty()) notice_panel(notices, room, page);
    const bool at_settings = settings.covers(static_cast<float>(hover_x), static_cast<float>(hover_y));
    if (names_nodes && !at_settings) hierarchy_.name_node(view, camera, hover_x, hover_y, {w, h, margin});
    ImGui::End();
    if (shown.controls) {
        settings.draw(*view.settings, page);
    } else {
        hide_settings();
    }
    ImGui::PopFont();
    ImGui::Render();
    return ImGui::GetDrawData()->TotalIdxCount > 0;
}

void OverlayPanels::legends(const FrameView& view, float taken, OverlayPage page) {
    if (view.settings->view.bounds) page.height -= hierarchy_.draw(view, taken, page);
    if (colours.by != ColourBy::Plain) colour_panel(colours, shown_level(view).level, taken, page);
}

float OverlayPanels::help_panel(const OverlayPage& page, float taken) const {
    const KeyColumns columns = columns_of(help);
    const float margin = page.margin, room = page.height - 4 * margin;
    const float width =
        std::min(columns.width() + 2 * margin, std::max(page.width - taken - 2 * margin, page.width / 3));
    // Closer lines where they would not all fit
    const float row = std::clamp(room / static_cast<float>(help.size()), ImGui::GetTextLineHeight(),
                                 ImGui::GetTextLineHeightWithSpacing());
    const auto fitting = static_cast<std::size_t>(std::max(1.0f, room / row));
    const ImVec2 corner{page.width - width - margin, margin};
    key_panel({help.data(), std::min(help.size(), fitting)}, columns, row, corner, width, margin);
    return corner.x;
}

void OverlayPanels::hint_panel(const OverlayPage& page, float right) const {
    const KeyColumns columns = columns_of(hint);
    const float margin = page.margin, row = ImGui::GetTextLineHeightWithSpacing();
    const float width = std::min(columns.width() + 2 * margin, page.width - 2 * margin);
    const float height = static_cast<float>(hint.size()) * row + 2 * margin;
    if (height + 2 * margin > page.height / 2) return;
    const float left = std::max((right - width) / 2, margin);
    key_panel(hint, columns, row, {left, page.height - height - margin}, width, margin);
}

}  // namespace drape
