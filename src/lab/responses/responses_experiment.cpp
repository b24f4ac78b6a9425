#include <fmt/core.h>

#include <algorithm>
#include <limits>

#include "lab/experiments.h"
#include "responses.h"

namespace drape {
namespace {

/// A line of the table: one response at one step, or the step limit of one penalty.
struct ResponseRow {
    static constexpr double none = std::numeric_limits<double>::quiet_NaN();

    std::string part;      ///< step or limit
    std::string response;  ///< at a step
    double step = none;
    double impact_error = none, height_error = none;  ///< of `Bounce`
    double drift = none, sweeps = none;               ///< of `Slide`
    Quartiles cost{none, none, none};
    double stiffness = none, restitution = none;  ///< of a penalty
    double predicted = none, measured = none;     ///< its limits [s]
};

using ResponseRows = std::vector<ResponseRow>;

ResponseRows run_step(ResponseKind kind, double step) {
    const Bounce bounce = drop_sheet(kind, static_cast<Real>(step));
    const Slide slide = lay_on_slope(kind, static_cast<Real>(step));
    ResponseRow row{.part = "step", .response = name_of(kind), .step = step};
    row.impact_error = bounce.impact_error, row.height_error = bounce.height_error;
    row.drift = slide.drift, row.sweeps = slide.sweeps, row.cost = slide.cost;
    return {row};
}

ResponseRows run_limit(double stiffness, double restitution) {
    const PenaltyLimit limit = find_penalty_limit(static_cast<Real>(stiffness), static_cast<Real>(restitution));
    ResponseRow row{.part = "limit", .response = name_of(ResponseKind::Penalty)};
    row.stiffness = stiffness, row.restitution = restitution;
    row.predicted = limit.predicted, row.measured = limit.measured;
    return {row};
}

std::vector<CaseOf<ResponseRow>> response_cases(bool quick) {
    std::vector<CaseOf<ResponseRow>> all;
    const auto rates = quick ? std::vector{60.0, 240.0, 960.0, 3840.0}
                             : std::vector{60.0, 120.0, 240.0, 480.0, 960.0, 1920.0, 3840.0, 7680.0, 15360.0};
    for (const std::string& response : names_of<ResponseKind>()) {
        const ResponseKind kind = value_named<ResponseKind>(response).value();
        for (const double rate : rates) all.push_back([=] { return run_step(kind, 1 / rate); });
    }
    for (const double stiffness : quick ? std::vector{1e2, 1e3} : std::vector{1e1, 1e2, 1e3, 1e4, 1e5}) {
        for (const double restitution : {0.0, 0.5, 1.0})
            all.push_back([=] { return run_limit(stiffness, restitution); });
    }
    return all;
}

RowFormat<ResponseRow> response_format() {
    using Row = ResponseRow;
    const auto of_step = [](const Column& column) { return column.or_nan().where("part", {"limit"}); };
    const auto of_limit = [](const Column& column) { return column.or_nan().where("part", {"step"}); };
    return {5,
            {{word_column("part", {"step", "limit"}), &Row::part},
             {name_column<ResponseKind>("response"), &Row::response},
             {of_step(positive_column("step_s")), &Row::step},
             {number_column("impact_error_s").or_nan(), &Row::impact_error},
             {of_step(number_column("height_error")), &Row::height_error},
             {of_step(number_column("drift_m_per_s")), &Row::drift},
             {of_step(number_column("sweeps")), &Row::sweeps},
             {of_step(number_column("respond_s")), &Row::cost},
             {of_limit(positive_column("stiffness_N_per_m")), &Row::stiffness},
             {of_limit(number_column("restitution")), &Row::restitution},
             {of_limit(positive_column("predicted_step_s")), &Row::predicted},
             {of_limit(positive_column("measured_step_s")), &Row::measured}}};
}

std::string response_summary(const ResponseRows& rows) {
    std::string text;
    for (const ResponseRow& row : rows_with(rows, &ResponseRow::part, "step")) {
        text += fmt::format(
            "{} at a step of {:.3g} ms: time of impact off by {:.3g} ms, height of the bounce off by {:.3g} %, drift "
            "{:.3g} "
            "mm/s\n",
            row.response, 1e3 * row.step, 1e3 * row.impact_error, 1e2 * row.height_error, 1e3 * row.drift);
    }
    for (const ResponseRow& row : rows_with(rows, &ResponseRow::part, "limit")) {
        text += fmt::format("penalty of {} N/m, restitution {}: longest step predicted {:.3g} ms, measured {:.3g} ms\n",
                            row.stiffness, row.restitution, 1e3 * row.predicted, 1e3 * row.measured);
    }
    return text;
}

std::vector<Chart> response_charts(const ResponseRows& rows) {
    const auto steps = rows_with(rows, &ResponseRow::part, "step"),
               limits = rows_with(rows, &ResponseRow::part, "limit");
    std::vector<Chart> charts;
    if (!steps.empty()) {
        charts.push_back({"responses",
                          "responses",
                          "A sheet that falls onto the ground, by its step: the errors of the time of the impact and "
                          "of the height to which it bounces; and how fast a sheet drifts that should stick to a "
                          "slope.",
                          {{"responses", in_words(words_of(steps, &ResponseRow::response))}}});
    }
    if (!limits.empty()) {
        charts.push_back({"responses_limit",
                          "responses_limit",
                          "The longest step at which a penalty does not throw off a sheet that rests on it, against "
                          "its stiffness: lines as predicted, points as measured.",
                          {}});
    }
    return charts;
}

}  // namespace

Experiment responses_experiment() {
    return ExperimentOf<ResponseRow>{"responses",       "which response is right, and at which step?",
                                     response_format(), response_cases,
                                     response_charts,   response_summary}
        .as_table();
}

}  // namespace drape
