#include "overlay_panels.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "contact_forces.h"

namespace drape {

namespace {

constexpr std::array<float, 8> font_sizes{11, 14, 17, 22, 28, 36, 46, 60};  // pixel

// Below this nothing could be read
constexpr int least_width = 120, least_height = 60;

constexpr ImGuiWindowFlags window_flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoBackground |
                                          ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoNav |
                                          ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoMove;

void add_fonts(std::array<PanelFont, font_sizes.size()>& fonts) {
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    const std::filesystem::path file = DRAPE_FONT;
    std::error_code ignored;
    const bool found = std::filesystem::is_regular_file(file, ignored);
    for (std::size_t i = 0; i < fonts.size(); ++i) {
        fonts[i].size = font_sizes[i];
        if (found) {
            fonts[i].font = atlas.AddFontFromFileTTF(file.c_str(), font_sizes[i]);
        } else {
            ImFontConfig config;
            config.SizePixels = font_sizes[i];
            fonts[i].font = atlas.AddFontDefault(&config);
        }
    }
    atlas.Build();
}

// The largest font that is not larger than a window should have on a usual display; one more is left for titles
std::size_t usual_font(double side, double text_scale) {
    const double wanted = text_scale * (side < 600 ? 11 : side < 1000 ? 14 : side < 1300 ? 17 : side < 1800 ? 22 : 28);
    std::size_t size = 0;
    while (size + 2 < font_sizes.size() && static_cast<double>(font_sizes[size + 1]) <= wanted) ++size;
    return size;
}

// On a display with more pixels the one nearest to what is in proportion, but none smaller than on a usual display
std::size_t font_for(int width, int height, double text_scale, double display_scale) {
    const double side = std::min(height, 2 * width / 3);
    const double wanted = display_scale * static_cast<double>(font_sizes[usual_font(side / display_scale, text_scale)]);
    const auto distance = [&](std::size_t font) { return std::abs(static_cast<double>(font_sizes[font]) - wanted); };
    std::size_t size = usual_font(side, text_scale);
    while (size + 2 < font_sizes.size() && distance(size + 1) < distance(size)) ++size;
    return size;
}

float margin_for(float font) { return font <= font_sizes[0] ? 8.0f : std::max(12.0f, 0.7f * font); }

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
    constexpr std::pair<ImGuiCol, ImU32> colours[] = {
        {ImGuiCol_FrameBg, ink::groove},  {ImGuiCol_FrameBgHovered, ink::lit},       {ImGuiCol_FrameBgActive, ink::lit},
        {ImGuiCol_SliderGrab, ink::grab}, {ImGuiCol_SliderGrabActive, ink::grabbed}, {ImGuiCol_CheckMark, ink::bar},
        {ImGuiCol_Header, ink::groove},   {ImGuiCol_HeaderHovered, ink::lit},        {ImGuiCol_HeaderActive, ink::lit},
        {ImGuiCol_Button, ink::groove},   {ImGuiCol_ButtonHovered, ink::lit},        {ImGuiCol_ButtonActive, ink::lit},
        {ImGuiCol_PopupBg, ink::popup}};
    for (const auto& [part, colour] : colours) style.Colors[part] = ImGui::ColorConvertU32ToFloat4(colour);
}

// The keys of a text field, by the character that they make
constexpr std::array<std::pair<ImGuiKey, unsigned char>, 3> field_keys{
    {{ImGuiKey_Backspace, 8}, {ImGuiKey_Enter, 13}, {ImGuiKey_Escape, 27}}};

#if IMGUI_VERSION_NUM < 18700  // which had no events: Debian 12

void expect_keys(ImGuiIO& io) {
    for (const auto& [key, code] : field_keys) io.KeyMap[key] = code;
}

void set_key(ImGuiIO& io, ImGuiKey, unsigned char code, bool down) { io.KeysDown[code] = down; }

void set_pointer(ImGuiIO& io, const PanelPointer& pointer, bool control) {
    io.MousePos = {static_cast<float>(pointer.x), static_cast<float>(pointer.y)};
    io.MouseDown[0] = pointer.down;
    io.MouseWheel = static_cast<float>(pointer.notches);
    io.KeyCtrl = control;
}

#else

// One frame gets one press at a time anyway
void expect_keys(ImGuiIO& io) { io.ConfigInputTrickleEventQueue = false; }

void set_key(ImGuiIO& io, ImGuiKey key, unsigned char, bool down) { io.AddKeyEvent(key, down); }

void set_pointer(ImGuiIO& io, const PanelPointer& pointer, bool control) {
    io.AddKeyEvent(ImGuiMod_Ctrl, control);
    io.AddMousePosEvent(static_cast<float>(pointer.x), static_cast<float>(pointer.y));
    io.AddMouseButtonEvent(0, pointer.down);
    io.AddMouseWheelEvent(0, static_cast<float>(pointer.notches));
}

#endif

// Whether the panels that are shown have room beside and below one another
bool panels_fit(const ViewSettings& shown, bool hinted, float width, float height, float font) {
    const float margin = margin_for(font);
    float columns = 0, rows = 0, margins = 1;
    if (shown.panel != PanelSize::Off) columns += figures_columns, margins += 3, rows = 12;
    if (shown.controls && !shown.help) columns += SettingsPanel::columns, margins += 1, rows = 12;
    if (hinted && (shown.controls || shown.panel == PanelSize::Full)) columns += hint_columns;
    if (hinted) rows += 10;
    if (shown.plots) columns = std::max(columns, plots_columns), rows += plots_rows + 2;
    return columns * font + margins * margin <= width && rows * font <= height;
}

// At the top where there is room for it beside the others, else at the bottom; what is said is never left out
float notice_panel(std::span<const std::string> notices, std::span<const PanelFont> fonts, const OverlayPage& page,
                   const std::vector<PanelBox>& others, bool at_top) {
    const float margin = page.margin;
    std::string text;
    for (const std::string& notice : notices) text += (text.empty() ? "" : "\n") + notice;
    const auto size_within = [&](float width) {
        const ImVec2 size = wrapped_size(text, width - 2 * margin);
        return ImVec2{size.x + 2 * margin, size.y + 2 * margin};
    };
    std::optional<PanelBox> box;
    for (std::size_t font = fonts.size(); font-- > 0 && !box;) {
        fonts[font].push();
        const float least = std::min(size_within(1e6f).x, 20 * ImGui::GetFontSize());
        if (at_top) box = free_place(page, others, size_within, least, true);
        if (!box) box = free_place(page, others, size_within, least, false);
        // Rather many short lines than over another panel
        if (!box && font == 0) box = free_place(page, others, size_within, 9 * ImGui::GetFontSize(), at_top);
        if (!box && font == 0) {
            const ImVec2 size = size_within(page.width - 2 * margin);
            box = PanelBox{margin, margin, margin + size.x, std::min(margin + size.y, page.height - margin)};
        }
        if (box) {
            draw_panel(*box);
            const float most = box->right - box->left - 2 * margin + 1;
            wrapped_text({box->left + margin, box->top + margin}, most, ink::wait, text);
        }
        ImGui::PopFont();
    }
    return box->top;
}

}  // namespace

OverlayPanels::OverlayPanels() {
    IMGUI_CHECKVERSION();
    context_.reset(ImGui::CreateContext(), ImGui::DestroyContext);
    ImGui::SetCurrentContext(context_.get());
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.LogFilename = nullptr;
    io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
    expect_keys(io);
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

bool OverlayPanels::have_pointer() const {
    ImGui::SetCurrentContext(context_.get());
    const PanelPointer& pointer = input_.next.empty() ? input_.seen : input_.next.back();
    const auto x = static_cast<float>(pointer.x), y = static_cast<float>(pointer.y);
    const bool shown = settings.window.width() > 0 || shows_timeline();
    return menu.is_open() || settings.window.covers(x, y) || timeline_.covers(x, y) ||
           (shown && ImGui::GetIO().WantCaptureMouse);
}

bool OverlayPanels::have_keyboard() const {
    ImGui::SetCurrentContext(context_.get());
    return menu.is_open() || (settings.window.width() > 0 && ImGui::GetIO().WantTextInput);
}

void OverlayPanels::forget_input() {
    if (settings.window.width() == 0 && !shows_timeline() && !menu.is_open()) input_ = {};
}

void OverlayPanels::hand_over_input() {
    ImGuiIO& io = ImGui::GetIO();
    const bool was_down = input_.seen.down;
    input_.seen.notches = 0;
    if (!input_.next.empty()) {
        input_.seen = input_.next.front();
        input_.next.erase(input_.next.begin());
    }
    set_pointer(io, input_.seen, input_.seen.control && input_.seen.down && !was_down);

    // Characters up to the next key that makes none, and of those one in every other frame
    for (const auto& [key, code] : field_keys) set_key(io, key, code, false);
    while (!input_.typed.empty() && static_cast<unsigned char>(input_.typed.front()) >= ' ') {
        io.AddInputCharacter(static_cast<unsigned char>(input_.typed.front()));
        input_.typed.erase(input_.typed.begin());
    }
    input_.key_seen = !input_.key_seen && !input_.typed.empty();
    if (!input_.key_seen) return;
    for (const auto& [key, code] : field_keys) {
        if (code == static_cast<unsigned char>(input_.typed.front())) set_key(io, key, code, true);
    }
    input_.typed.erase(input_.typed.begin());
}

bool OverlayPanels::build(FrameView view, const Camera& camera, const FrameReport& last,
                          std::span<const std::string> notices, int width, int height) {
    const ViewSettings& shown = view.settings->view;
    step_medians_.keep(*view.report);
    const StepReport steady = step_medians_.with_median_times(*view.report);
    view.report = &steady;
    plots_.keep(view);
    comparison_.keep(view);
    const bool showing_help = shown.help && !help.empty();
    const bool showing_panel = shown.panel != PanelSize::Off;
    const bool hinted = !hint.empty() && !showing_help;
    const bool names_nodes = shown.bounds && hover_x >= 0 && !view.held;
    if (width < least_width || height < least_height) {
        settings.hide();
        timeline_ = {};
        forget_input();
        return false;
    }

    ImGui::SetCurrentContext(context_.get());
    const auto w = static_cast<float>(width), h = static_cast<float>(height);
    ImGui::GetIO().DisplaySize = {w, h};
    ImGui::GetIO().DeltaTime = 1.0f / 60;
    ImGui::GetIO().UserData = &boxes_;
    boxes_.clear();
    if (std::exchange(style_scale_, display_scale) != display_scale) {
        set_style();
        ImGui::GetStyle().ScaleAllSizes(static_cast<float>(display_scale));
    }
    std::size_t size = font_for(width, height, shown.text_scale, display_scale);
    while (size > 0 && !panels_fit(shown, hinted, w, h, font_sizes[size])) --size;
    const float margin = margin_for(font_sizes[size]);

    hand_over_input();
    ImGui::NewFrame();
    fonts_[size].push();
    ImGui::SetNextWindowPos({0, 0});
    ImGui::SetNextWindowSize({w, h});
    ImGui::Begin("overlay", nullptr, window_flags);
    OverlayPage page{w, h, margin};
    const float font = font_sizes[size];
    const std::span fonts(fonts_.data(), size + 1);
    const bool help_is_tight = showing_help && h < 50 * font;
    if (shown.plots && !help_is_tight) page.height -= plots_panel(plots_, page);
    timeline_ = timeline_panel(view, page, wishes.back);
    if (shows_timeline()) page.height = timeline_.top;
    const bool shows_settings = shown.controls && !showing_help;
    shows_settings ? settings.draw(view, page) : settings.hide();
    const float right = shows_settings ? settings.window.left - margin : w - margin;

    // Help is nearly as high as the page: above notices
    if (showing_help && !notices.empty()) page.height = notice_panel(notices, fonts, page, boxes_, false);

    // Help goes first where there is no room beside it
    bool beside = showing_panel;
    if (showing_help) beside = help_panel(help, fonts, page, showing_panel);
    // Nor is there room for a hint beside both other panels of a narrow page
    const float middle = right - 3 * margin - figures_columns * font;
    if (hinted && shown.controls && middle < hint_columns * font) beside = false;
    const ImVec2 pointer(static_cast<float>(hover_x), static_cast<float>(hover_y));
    const PanelBox figures = beside ? figures_panel(view, last, fonts_[size + 1], page, pointer) : PanelBox{};
    const float left = figures.right + margin;
    // On a small page a hint is worth more than legends
    const bool legend_room = !hinted || right - left > (hint_columns + 32) * font || page.height > 36 * font;
    if (!showing_help) {
        const bool compared = view.comparison != nullptr && comparison_.draw(view, page, left, right) < right;
        const bool low = compared && page.height < 46 * font;
        if (showing_panel && legend_room && !low) legends(view, left - margin, {right + margin, page.height, margin});
    }
    if (!showing_help && !notices.empty()) notice_panel(notices, fonts, page, boxes_, true);
    if (hinted) hint_panel(hint, fonts, page, boxes_);
    const auto covers = [&](const PanelBox& box) { return box.covers(pointer.x, pointer.y); };
    if (names_nodes && std::ranges::none_of(boxes_, covers)) node_panel(view, camera, hover_x, hover_y, {w, h, margin});
    ImGui::End();
    menu.draw(view, {w, h, margin});
    forget_input();
    ImGui::PopFont();
    ImGui::Render();
    return ImGui::GetDrawData()->TotalIdxCount > 0;
}

void OverlayPanels::legends(const FrameView& view, float taken, OverlayPage page) {
    if (view.settings->view.bounds) page.height -= hierarchy_panel(view, fits_, taken, page);
    if (const double full = view.settings->view.contacts ? full_force(view) : 0; full > 0) {
        page.height -= line_panel(format("force on cloth; longest: %g mN", 1e3 * full), hold_looks, taken, page);
    }
    if (colours.by == ColourBy::PrincipalStrain) {
        page.height -= line_panel(format("strain of cells; longest: %g %% or more", full_strain),
                                  std::span(node_looks).last(2), taken, page);
    }
    if (colours.by != ColourBy::Plain) colour_panel(colours, shown_level(view).level, taken, page);
}

}  // namespace drape
