#include "overlay_panels.h"

#include <imgui.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>

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
    const float margin = size == 0 ? 8.0f : 12.0f;

    ImGui::NewFrame();
    ImGui::SetNextWindowPos({0, 0});
    ImGui::SetNextWindowSize({w, h});
    ImGui::Begin("overlay", nullptr, window_flags);
    ImGui::PushFont(fonts_[size]);
    float taken = 0;
    if (shown.overlay) taken = figures_panel(view, last, fonts_[size + 1], {w, h, margin});
    if (showing_help) {
        help_panel({w, h, margin}, taken);
    } else if (shown.overlay) {
        legends(view, taken, {w, h, margin});
    }
    if (!notices.empty()) notice_panel(notices, {w, h, margin});
    ImGui::PopFont();
    ImGui::End();
    ImGui::Render();
    return ImGui::GetDrawData()->TotalIdxCount > 0;
}

void OverlayPanels::legends(const FrameView& view, float taken, OverlayPage page) {
    if (view.settings->view.bounds) page.height -= hierarchy_.draw(view, taken, page);
    if (colours.by != ColourBy::Plain) colour_panel(colours, shown_level(view).level, taken, page);
}

void OverlayPanels::help_panel(const OverlayPage& page, float taken) const {
    const float row = ImGui::GetTextLineHeightWithSpacing(), gap = ImGui::GetFontSize();
    float keys = 0, texts = 0;
    for (const KeyHelp& line : help) {
        keys = std::max(keys, ImGui::CalcTextSize(line.key.c_str()).x);
        texts = std::max(texts, ImGui::CalcTextSize(line.text.c_str()).x);
    }
    const float margin = page.margin;
    const float width =
        std::min(keys + gap + texts + 2 * margin, std::max(page.width - taken - 2 * margin, page.width / 3));
    const auto fitting = static_cast<std::size_t>(std::max(1.0f, (page.height - 4 * margin) / row));
    const std::size_t rows = std::min(help.size(), fitting);

    ImVec2 corner{page.width - width - margin, margin};
    draw_panel(corner, {width, static_cast<float>(rows) * row + 2 * margin});
    corner = {corner.x + margin, corner.y + margin};
    for (std::size_t i = 0; i < rows; ++i) {
        text_at(corner, ink::wait, help[i].key.c_str());
        text_at({corner.x + keys + gap, corner.y}, ink::text, help[i].text.c_str());
        corner.y += row;
    }
}

void OverlayPanels::notice_panel(std::span<const std::string> notices, const OverlayPage& page) const {
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
}

}  // namespace drape
