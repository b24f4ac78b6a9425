#include "panels.h"

#include <imgui.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <iterator>
#include <vector>

#include "drape/bounds/broad_phase.h"
#include "drape/integrate/integrator.h"
#include "figure_help.h"

namespace drape {

namespace {

struct Row {
    std::string name;
    std::string value;
    int importance;  // rows of the lowest go first where there is no room
    ImU32 colour = ink::text;
    float part = -1;  // of a bar, in [0, 1]; below 0 there is none
    bool opens_group = false;
};

// 1234567 as "1 234 567"
std::string grouped(double value) {
    const std::string digits = format("%.0f", value);
    std::string text;
    for (std::size_t i = 0; i < digits.size(); ++i) {
        if (i > 0 && (digits.size() - i) % 3 == 0 && digits[i - 1] != '-') text += ' ';
        text += digits[i];
    }
    return text;
}

std::string time_text(double microseconds) {
    return microseconds < 999.95 ? format("%.1f us", microseconds) : format("%.2f ms", microseconds / 1000);
}

// A value as its unit is best read
std::string value_text(double value, std::string_view unit) {
    if (unit.empty()) return grouped(value);
    if (unit == "1") return format("%.2f %%", 100 * value);
    if (unit == "us") return time_text(value);
    if (unit == "m") return format("%.2f mm", 1000 * value);
    if (unit == "J") return format("%.4f J", std::round(1e4 * value) / 1e4 + 0.0);  // without a sign of zero
    return format("%.3f", value) + " " + std::string(unit);
}

// Of a part, times get a bar beside them, and counts the count of the whole
Row report_row(const ReportField& field, const StepReport& report) {
    const double value = field.read(report);
    Row row{std::string(field.label), value_text(value, field.unit), field.importance};
    if (field.group == ReportGroup::Balance && row.value == value_text(0, field.unit)) {
        row.importance = 2, row.colour = ink::dim;
    }
    if (field.whole == nullptr) return row;
    const double whole = field.whole(report);
    if (field.unit.empty()) {
        row.value += " of " + grouped(whole);
    } else {
        row.part = whole > 0 ? static_cast<float>(value / whole) : 0;
    }
    return row;
}

Row state_row(const FrameView& view) {
    const StepReport& report = *view.report;
    if (report.status == Status::Diverged) return {"state", "diverged", 4, ink::bad};
    if (!view.timeline.is_computed) return {"state", "computing this moment", 4, ink::wait};
    if (view.paused) return {"state", report.asleep ? "paused, asleep" : "paused", 4, ink::wait};
    if (report.energy_gain_step > 0) return {"state", "running, gains energy", 4, ink::bad};
    if (in_doubt(report)) return {"state", "running, unsolved", 4, ink::bad};
    if (report.asleep) return {"state", "asleep", 4, ink::quiet};
    if (view.timeline.replay || !view.timeline.is_live()) return {"state", "replaying", 4, ink::wait};
    return {"state", view.held ? "running, in hand" : "running", 4, ink::good};
}

// How near a step is to its limit
std::string limit_text(const StepReport& report) {
    if (!std::isfinite(report.step_limit_ratio)) return "no stable step";
    return format(report.limit_is_lower_bound ? "%.2f at most" : "%.2f", report.step_limit_ratio);
}

ImU32 limit_colour(double ratio) { return ratio <= 0.9 ? ink::good : ratio <= 1 ? ink::wait : ink::bad; }

void add_speed_row(const FrameView& view, std::vector<Row>& rows) {
    if (const double speed = view.settings->view.speed; speed != 1) {
        rows.push_back({"speed", format("%.3g x real time", speed), 3, ink::wait});
    }
}

// The step or the substeps that it is divided into, and how near they are to the limit
void add_step_rows(const FrameView& view, std::vector<Row>& rows) {
    const StepReport& report = *view.report;
    const double substep = view.settings->solver.dt / report.substeps;
    std::string text = report.substeps > 1 ? format("%d x ", report.substeps) : "";
    text += format("%.3g ms", 1000 * substep);
    rows.push_back({"time step", text, 3});
    add_speed_row(view, rows);
    const double ratio = report.step_limit_ratio;
    if (ratio == 0) return;
    const auto part = static_cast<float>(std::min(ratio, 1.0));
    rows.push_back({"dt / limit", limit_text(report), 4, limit_colour(ratio), part});
    if (std::isfinite(ratio)) rows.push_back({"limit", format("%.3g ms", 1000 * substep / ratio), 2});
}

// Of every cell, for every ball; 0 where no hierarchy saves any
double tests_of_brute_force(const FrameView& view) {
    if (view.settings->contact.volume == VolumeKind::Brute) return 0;
    double cells = 0;
    for (const ClothView& cloth : view.cloths) cells += cloth.model.grid.cells();
    return cells * static_cast<double>(view.balls.size());
}

// Whether the search for balls leaves more than half of the cells that brute force tests: then no update, however
// cheap, saves much
bool most_is_near(const FrameView& view) {
    return 2 * static_cast<double>(view.report->traversal.candidates) > tests_of_brute_force(view);
}

// What it saves of the tests that brute force makes, and whether of its time too, where that was measured. Where a
// cloth is small and most of it near a ball, that is none.
void add_saved_row(const FrameView& view, std::vector<Row>& rows) {
    const double all = tests_of_brute_force(view);
    const TraversalStats& traversal = view.report->traversal;
    const auto made = static_cast<double>(traversal.candidates + traversal.volume_tests);
    if (view.search == nullptr && (all == 0 || made == 0)) return;
    const double saved = view.search != nullptr ? view.search->tests_saved() : 1 - made / all;
    if (saved < 0.05) {
        rows.push_back({"tests saved", most_is_near(view) ? "none: most is near" : "none", 3, ink::wait});
        return;
    }
    const std::string text = format("%.0f %%", std::floor(100 * saved));
    const bool shows_how = view.settings->view.bounds;
    if (view.search == nullptr) {
        rows.push_back({"tests saved", text + (shows_how ? " of " + grouped(all) : "; B shows how"), 3});
    } else if (view.search->saves_time()) {
        const double speed_up = view.search->speed_up();
        const std::string times = format(speed_up < 10 ? ", %.1fx as fast" : ", %.0fx as fast", speed_up);
        rows.push_back({"tests saved", text + times + (shows_how ? "" : " (B)"), 3, ink::good});
    } else {
        rows.push_back({"tests saved", text + ", but no time", 3, ink::wait});
    }
}

// What a search takes, and without the hierarchy; where that takes less, what to press: another update or volume, or
// the scene `large`
void add_search_rows(const FrameView& view, std::vector<Row>& rows) {
    if (view.search == nullptr) return;
    const SearchTimes& search = *view.search;
    rows.push_back({"tests, in all", grouped(search.tests) + " of " + grouped(search.tests_of_brute_force), 1});
    rows.push_back({"search, in all", time_text(1e6 * search.hierarchy), 2});
    rows.push_back({"by brute force", time_text(1e6 * search.brute_force), 2});
    if (search.saves_time()) return;
    rows.push_back({"to save time", most_is_near(view) ? "9: a larger sheet" : "U: update, T: volume", 2, ink::wait});
}

// What stands above the figures of a group
void add_rows_ahead(ReportGroup group, const FrameView& view, std::vector<Row>& rows) {
    const Settings& settings = *view.settings;
    if (group == ReportGroup::Time) {
        rows.push_back(state_row(view));
        rows.push_back({"integrator", name_of(settings.solver.integrator), 4});
        add_step_rows(view, rows);
    } else if (group == ReportGroup::Hierarchy) {
        const ContactSettings& contact = settings.contact;
        const std::string fit = contact.volume == VolumeKind::Sphere ? ", " + name_of(contact.sphere_fit) : "";
        rows.push_back({"volume", name_of(contact.volume) + fit, 2});
        rows.push_back({"update", name_of(contact.update), 1});
        add_saved_row(view, rows);
        add_search_rows(view, rows);
    }
}

// Of what is at rest there is no rate. Where the window draws fast, the picture says so
void add_rate_row(const FrameView& view, const FrameReport& last, std::vector<Row>& rows) {
    if (is_at_rest(view)) return;
    const std::string rate = format("%.1f", last.rate);
    rows.push_back(view.prefer_speed ? Row{"FPS", rate + ", coarse", 3, ink::wait} : Row{"FPS", rate, 3});
}

// Where energy went to and came from, while a ledger is kept
void add_balance_rows(const FrameView& view, std::vector<Row>& rows) {
    if (!view.settings->solver.ledger) return;
    const std::size_t first = rows.size();
    for (const ReportField& field : report_fields()) {
        if (field.group == ReportGroup::Balance) rows.push_back(report_row(field, *view.report));
    }
    rows[first].opens_group = true;
}

// What a glance takes in, and what the user has asked for
void add_compact_rows(const FrameView& view, const FrameReport& last, std::vector<Row>& rows) {
    rows.push_back(state_row(view));
    add_rate_row(view, last, rows);
    add_speed_row(view, rows);
    const StepReport& report = *view.report;
    const double ratio = report.step_limit_ratio;
    if (ratio > 0.9) rows.push_back({"dt / limit", limit_text(report), 3, limit_colour(ratio)});
    const auto count = static_cast<double>(report.pairs);
    const std::string pairs = report.pairs > 0 ? ", " + grouped(count) + (report.pairs > 1 ? " pairs" : " pair") : "";
    rows.push_back({"contacts", grouped(static_cast<double>(report.contacts)) + pairs, 3});
    add_saved_row(view, rows);
    add_balance_rows(view, rows);
}

// Every figure of a step that has a label, group by group
void add_report_rows(const FrameView& view, std::vector<Row>& rows) {
    const bool limited = !broad_phase_of(*view.settings).search.none();
    const double all_cells = tests_of_brute_force(view);
    const ReportField* before = nullptr;
    for (const ReportField& field : report_fields()) {
        if (field.label.empty() || (field.group == ReportGroup::Limit && !limited)) continue;
        if (field.group == ReportGroup::Pairs && !view.settings->contact.self) continue;
        if (field.group == ReportGroup::Doubt && !in_doubt(*view.report)) continue;
        if (field.group == ReportGroup::Balance && !view.settings->solver.ledger) continue;
        if (field.unit == "us" && field.read(*view.report) == 0) continue;  // asleep, or nothing to do
        const bool opens = before == nullptr || before->group != field.group;
        const std::size_t first = rows.size();
        if (opens) add_rows_ahead(field.group, view, rows);
        rows.push_back(report_row(field, *view.report));
        if (field.name == "candidates" && all_cells > 0) rows.back().value += " of " + grouped(all_cells) + " cells";
        rows[first].opens_group = opens && before != nullptr;
        before = &field;
    }
}

void add_cost_rows(const FrameView& view, const FrameReport& last, std::vector<Row>& rows) {
    const std::size_t first = rows.size();
    add_rate_row(view, last, rows);
    rows.push_back({"CPU", format("%.0f %%", 100 * last.cpu), 2});
    rows.push_back({"GL calls", grouped(last.gl_calls), 2});
    rows.push_back({"vertices", grouped(last.vertices), 2});
    rows[first].opens_group = true;
}

float height_of(const std::vector<Row>& rows, float line, float gap) {
    float height = 0;
    for (const Row& row : rows) height += line + (row.opens_group ? gap : 0);
    return height;
}

// Leaves out rows until the rest fits, and says so
void drop_rows(std::vector<Row>& rows, float line, float gap, float room) {
    int dropped = 0;
    for (; !rows.empty() && height_of(rows, line, gap) + (dropped > 0 ? line : 0) > room; ++dropped) {
        const auto least = std::min_element(rows.rbegin(), rows.rend(),
                                            [](const Row& a, const Row& b) { return a.importance < b.importance; });
        const bool opens = least->opens_group;
        const auto next = rows.erase(std::next(least).base());
        if (opens && next != rows.end()) next->opens_group = true;
    }
    if (dropped > 0 && !rows.empty()) rows.push_back({format("no room for %d more", dropped), "", 0});
}

// A title in the large font where that fits into a line; else in the small one, in two lines, and cut where it is
// longer
struct Title {
    PanelFont font;
    std::string text;
    float height;
};

float height_within(float room, const PanelFont& font, const std::string& text) {
    return font.font->CalcTextSizeA(font.size, FLT_MAX, room, text.c_str()).y;
}

Title fit_title(std::string text, const PanelFont& large, float room) {
    if (text.empty()) text = "Drape";
    if (height_within(room, large, text) <= large.size) return {large, text, large.size};
    const PanelFont font{ImGui::GetFont(), ImGui::GetFontSize()};
    const float most = 2 * font.size;
    std::string shown = text;
    while (!text.empty() && height_within(room, font, shown) > most) {
        // A whole character at a time
        while (!text.empty() && (text.back() & 0xC0) == 0x80) text.pop_back();
        if (!text.empty()) text.pop_back();
        shown = text + "...";
    }
    return {font, shown, height_within(room, font, shown)};
}

// Where the parts of a row start, and where it ends
struct Columns {
    float name, value, bar, end;
};

void draw_row(const Row& row, float top, const Columns& columns) {
    text_at({columns.name, top}, ink::quiet, row.name);
    text_at({columns.value, top}, row.colour, row.value);
    const bool room = columns.value + text_width(row.value) < columns.bar;
    if (row.part < 0 || !room) return;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float line = ImGui::GetTextLineHeight(), upper = top + 0.36f * line, lower = top + 0.74f * line;
    list.AddRectFilled({columns.bar, upper}, {columns.end, lower}, ink::groove, 2);
    const float filled = row.part * (columns.end - columns.bar);
    if (filled > 1) list.AddRectFilled({columns.bar, upper}, {columns.bar + filled, lower}, ink::bar, 2);
}

}  // namespace

PanelBox figures_panel(const FrameView& view, const FrameReport& last, const PanelFont& title, const OverlayPage& page,
                       ImVec2 pointer) {
    std::vector<Row> rows;
    if (view.settings->view.panel == PanelSize::Compact) {
        add_compact_rows(view, last, rows);
    } else {
        add_report_rows(view, rows);
        add_cost_rows(view, last, rows);
        // What the lines on the ground are apart
        if (view.settings->view.grid) rows.push_back({"ground grid", "10 cm, 1 m", 1});
    }

    // As large as it must be, at most as the picture
    const float margin = page.margin, size = ImGui::GetFontSize();
    const float line = ImGui::GetTextLineHeightWithSpacing(), gap = 0.45f * size;
    const float width = std::min(figures_columns * size + 2 * margin, page.width - 2 * margin);
    const Title shown = fit_title(view.settings->title, title, width - 2 * margin);
    const float title_height = shown.height + 0.4f * size;
    drop_rows(rows, line, gap, page.height - 4 * margin - title_height);
    const float height = std::min(height_of(rows, line, gap) + title_height + 2 * margin, page.height - 2 * margin);
    const PanelBox box{margin, margin, margin + width, margin + height};
    draw_panel(box);

    shown.font.push();
    ImGui::PushTextWrapPos(width);
    text_at({2 * margin, 2 * margin}, ink::text, shown.text);
    ImGui::PopTextWrapPos();
    ImGui::PopFont();
    const float value = 2 * margin + 7.2f * size;
    const Columns columns{2 * margin, value, value + 5.2f * size, width};
    float top = 2 * margin + title_height;
    for (const Row& row : rows) {
        if (row.opens_group) top += gap;
        draw_row(row, top, columns);
        if (PanelBox{box.left, top, box.right, top + line}.covers(pointer.x, pointer.y)) {
            tooltip({{ink::text, std::string(figure_help(row.name))}}, ImVec2{box.right + margin / 2, top});
        }
        top += line;
    }
    return box;
}

}  // namespace drape
