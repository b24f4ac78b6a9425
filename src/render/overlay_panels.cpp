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

constexpr std::array<float, 4> font_sizes{11, 14, 17, 22};  // pixel

// Below this nothing could be read
constexpr int least_width = 120, least_height = 60;

constexpr ImGuiWindowFlags window_flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoBackground |
                                          ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoNav |
                                          ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoMove;

void add_fonts(std::array<ImFont*, 4>& fonts) {
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

void key_panel(std::span<const KeyHelp> lines, const KeyColumns& columns, ImVec2 corner, float width, float margin) {
    const float row = ImGui::GetTextLineHeightWithSpacing();
    draw_panel(corner, {width, static_cast<float>(lines.size()) * row + 2 * margin});
    corner = {corner.x + margin, corner.y + margin};
    for (const KeyHelp& line : lines) {
        text_at(corner, ink::wait, line.key.c_str());
        text_at({corner.x + columns.texts_from, corner.y}, ink::text, line.text.c_str());
        corner.y += row;
    }
}

// @return the height that is taken at the bottom [pixel]
float notice_panel(std::span<const std::string> notices, const OverlayPage& page) {
    const float most = page.width - 4 * page.margin;
    ImVec2 size{0, 0};
    for (const std::string& notice : notices) {
        const ImVec2 part = ImGui::CalcTextSize(notice.c_str(), nullptr, false, most);
        size = {std::max(size.x, part.x), size.y + part.y};
    }
    const ImVec2 panel{size.x + 2 * page.margin, std::min(size.y + 2 * page.margin, page.height - 2 * page.margin)};
    const ImVec2 corner{(page.width - panel.x) / 2, page.height - panel.y - page.margin};
    draw_panel(corner, panel);

    ImVec2 line{corner.x + page.margin, corner.y + page.margin};
    ImGui::PushTextWrapPos(line.x + most + 1);
    for (const std::string& notice : notices) {
        text_at(line, ink::wait, notice.c_str());
        line.y += ImGui::CalcTextSize(notice.c_str(), nullptr, false, most).y;
    }
    ImGui::PopTextWrapPos();
    return panel.y + page.margin;
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
    const int notches = input_.pointer.notches + pointer.notches;
    input_.pressed = input_.pressed || (pointer.down && !input_.pointer.down);
    input_.pointer = pointer;
    input_.pointer.notches = notches;
}

void OverlayPanels::type(unsigned char code) { input_.typed += static_cast<char>(code); }

bool OverlayPanels::have_pointer() const {
    ImGui::SetCurrentContext(context_.get());
    return settings.covers(static_cast<float>(input_.pointer.x), static_cast<float>(input_.pointer.y)) ||
           ImGui::GetIO().WantCaptureMouse;
}

bool OverlayPanels::have_keyboard() const {
    ImGui::SetCurrentContext(context_.get());
    return ImGui::GetIO().WantTextInput;
}

void OverlayPanels::hand_over_input() {
    ImGuiIO& io = ImGui::GetIO();
    io.MousePos = {static_cast<float>(input_.pointer.x), static_cast<float>(input_.pointer.y)};
    io.MouseDown[0] = input_.pointer.down || input_.pressed;
    io.MouseWheel = static_cast<float>(input_.pointer.notches);
    io.KeyCtrl = input_.pressed && input_.pointer.control;
    for (const auto& [key, code] : field_keys) {
        io.KeysDown[code] = input_.typed.find(static_cast<char>(code)) != std::string::npos;
    }
    for (const char code : input_.typed) {
        if (code >= ' ') io.AddInputCharacter(static_cast<unsigned char>(code));
    }
    input_.pressed = false;
    input_.pointer.notches = 0;
    input_.typed.clear();
}

bool OverlayPanels::build(const FrameView& view, const FrameReport& last, std::span<const std::string> notices,
                          int width, int height) {
    const ViewSettings& shown = view.settings->view;
    plots_.keep(view);
    const bool showing_help = shown.help && !help.empty();
    if (width < least_width || height < least_height) return false;
    const bool showing_panel = shown.panel != PanelSize::Off;
    if (!showing_panel && !showing_help && notices.empty() && hint.empty() && !shown.controls && !shown.plots)
        return false;

    ImGui::SetCurrentContext(context_.get());
    const auto w = static_cast<float>(width), h = static_cast<float>(height);
    ImGui::GetIO().DisplaySize = {w, h};
    ImGui::GetIO().DeltaTime = 1.0f / 60;
    const std::size_t size = height < 600 || width < 900 ? 0 : height < 1000 ? 1 : 2;
    const float margin = size == 0 ? 8.0f : 12.0f;

    hand_over_input();
    ImGui::NewFrame();
    ImGui::PushFont(fonts_[size]);
    ImGui::SetNextWindowPos({0, 0});
    ImGui::SetNextWindowSize({w, h});
    ImGui::Begin("overlay", nullptr, window_flags);
    OverlayPage page{w, h, margin};
    if (shown.plots) page.height -= plots_.draw(page);
    float taken = 0;
    if (showing_panel) taken = figures_panel(view, last, fonts_[size + 1], page);
    if (showing_help) {
        help_panel(page, taken);
    } else if (showing_panel) {
        legends(view, settings.left() > 0 ? settings.left() - margin : w - margin, page);
    }
    float below = 0;
    if (!notices.empty()) below = notice_panel(notices, page);
    if (!hint.empty() && !showing_help) hint_panel(page, below);
    ImGui::End();
    if (shown.controls) {
        settings.draw(*view.settings, page);
    } else {
        settings.hide();
    }
    ImGui::PopFont();
    ImGui::Render();
    return ImGui::GetDrawData()->TotalIdxCount > 0;
}

void OverlayPanels::legends(const FrameView& view, float right, const OverlayPage& page) {
    if (view.settings->view.bounds) right = hierarchy_.draw(view, right, page) - page.margin;
    if (colours.by != ColourBy::Plain) colour_panel(colours, shown_level(view).level, right, page);
}

void OverlayPanels::help_panel(const OverlayPage& page, float taken) const {
    const KeyColumns columns = columns_of(help);
    const float margin = page.margin;
    const float width =
        std::min(columns.width() + 2 * margin, std::max(page.width - taken - 2 * margin, page.width / 3));
    const auto fitting =
        static_cast<std::size_t>(std::max(1.0f, (page.height - 4 * margin) / ImGui::GetTextLineHeightWithSpacing()));
    key_panel({help.data(), std::min(help.size(), fitting)}, columns, {page.width - width - margin, margin}, width,
              margin);
}

void OverlayPanels::hint_panel(const OverlayPage& page, float below) const {
    const KeyColumns columns = columns_of(hint);
    const float margin = page.margin;
    const float width = std::min(columns.width() + 2 * margin, page.width - 2 * margin);
    const float height = static_cast<float>(hint.size()) * ImGui::GetTextLineHeightWithSpacing() + 2 * margin;
    if (height + below + 2 * margin > page.height / 2) return;
    key_panel(hint, columns, {(page.width - width) / 2, page.height - below - height - margin}, width, margin);
}

}  // namespace drape
