#include "overlay_panels.h"

#include <imgui.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>

#include "figures_panel.h"
#include "overlay_style.h"

namespace drape {

namespace {

constexpr std::array<float, 4> font_sizes{11, 14, 17, 22};  // pixel

// Below this nothing could be read
constexpr int least_width = 120, least_height = 60;

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
    style.WindowRounding = 8;
    style.WindowBorderSize = 0;
    style.WindowMinSize = {1, 1};
    style.ItemSpacing = {6, 2};
    style.Colors[ImGuiCol_WindowBg] = ImGui::ColorConvertU32ToFloat4(ink::panel);
    style.Colors[ImGuiCol_Text] = ImGui::ColorConvertU32ToFloat4(ink::text);
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
    set_style();
    add_fonts(fonts_);
}

bool OverlayPanels::build(const FrameView& view, const FrameReport& last, std::span<const std::string> notices,
                          int width, int height) {
    const ViewSettings& shown = view.settings->view;
    const bool showing_help = shown.help && !help.empty();
    if (width < least_width || height < least_height) return false;
    if (!shown.overlay && !showing_help && notices.empty()) return false;

    ImGui::SetCurrentContext(context_.get());
    const auto w = static_cast<float>(width), h = static_cast<float>(height);
    ImGui::GetIO().DisplaySize = {w, h};
    ImGui::GetIO().DeltaTime = 1.0f / 60;
    const std::size_t size = height < 600 || width < 900 ? 0 : height < 1000 ? 1 : 2;
    text_ = fonts_[size];
    title_ = fonts_[size + 1];
    const float padding = size == 0 ? 8.0f : 12.0f;
    ImGui::GetStyle().WindowPadding = {padding, padding};

    ImGui::NewFrame();
    ImGui::PushFont(text_);
    float taken = 0;
    if (shown.overlay) taken = figures_panel(view, last, title_, w, h);
    if (showing_help) help_panel(w, h, taken);
    if (!notices.empty()) notice_panel(notices, w, h);
    ImGui::PopFont();
    ImGui::Render();
    return ImGui::GetDrawData()->TotalIdxCount > 0;
}

void OverlayPanels::help_panel(float width, float height, float taken) const {
    const ImGuiStyle& style = ImGui::GetStyle();
    const float margin = style.WindowPadding.y, row = ImGui::GetTextLineHeightWithSpacing();
    float keys = 0, texts = 0;
    for (const KeyHelp& line : help) {
        keys = std::max(keys, ImGui::CalcTextSize(line.key.c_str()).x);
        texts = std::max(texts, ImGui::CalcTextSize(line.text.c_str()).x);
    }
    const float gap = ImGui::GetFontSize();
    const float wanted = keys + gap + texts + 2 * style.WindowPadding.x + 1;
    const float panel_width = std::min(wanted, std::max(width - taken - 2 * margin, width / 3));
    const auto fitting = static_cast<std::size_t>(std::max(1.0f, (height - 4 * margin) / row));
    const std::size_t rows = std::min(help.size(), fitting);

    begin_panel("help", {width - panel_width - margin, margin},
                {panel_width, static_cast<float>(rows) * row + 2 * margin - style.ItemSpacing.y});
    for (std::size_t i = 0; i < rows; ++i) {
        coloured_text(ink::wait, help[i].key.c_str());
        ImGui::SameLine(style.WindowPadding.x + keys + gap);
        ImGui::TextUnformatted(help[i].text.c_str());
    }
    ImGui::End();
}

void OverlayPanels::notice_panel(std::span<const std::string> notices, float width, float height) const {
    const ImGuiStyle& style = ImGui::GetStyle();
    const float margin = style.WindowPadding.y, most = width - 2 * margin - 2 * style.WindowPadding.x;
    float text_width = 0, text_height = -style.ItemSpacing.y;
    for (const std::string& notice : notices) {
        const ImVec2 size = ImGui::CalcTextSize(notice.c_str(), nullptr, false, most);
        text_width = std::max(text_width, size.x);
        text_height += size.y + style.ItemSpacing.y;
    }
    const float panel_width = text_width + 2 * style.WindowPadding.x + 1;
    const float panel_height = std::min(text_height + 2 * margin, height - 2 * margin);

    begin_panel("notices", {(width - panel_width) / 2, height - panel_height - margin}, {panel_width, panel_height});
    ImGui::PushTextWrapPos(style.WindowPadding.x + most + 1);
    for (const std::string& notice : notices) coloured_text(ink::wait, notice.c_str());
    ImGui::PopTextWrapPos();
    ImGui::End();
}

}  // namespace drape
