#include "lab/experiments.h"
#include "lab/measure/methods.h"
#include "responses.h"

namespace drape {
namespace {

/// A line of the table: one response at one step, or the step limit of one penalty.
struct ResponseRow : Bounce, Slide, PenaltyLimit {
    std::string part;  ///< step or limit
    ResponseKind response{};
    double step = no_number;
    double stiffness = no_number, restitution = no_number;  ///< of a penalty
};

using ResponseRows = std::vector<ResponseRow>;

ResponseRows run_at_step(ResponseKind kind, double rate) {
    const auto step = static_cast<Real>(1 / rate);
    return {{drop_sheet(kind, step), lay_on_slope(kind, step), {}, "step", kind, 1 / rate}};
}

ResponseRows run_limit(double stiffness, double restitution) {
    const PenaltyLimit limit = find_penalty_limit(static_cast<Real>(stiffness), static_cast<Real>(restitution));
    return {{{}, {}, limit, "limit", ResponseKind::Penalty, no_number, stiffness, restitution}};
}

std::vector<CaseOf<ResponseRow>> step_cases(bool quick) {
    return cases_over(run_at_step, values_of<ResponseKind>(),
                      quick ? std::vector{60.0, 240.0, 960.0, 3840.0}
                            : std::vector{60.0, 120.0, 240.0, 480.0, 960.0, 1920.0, 3840.0, 7680.0, 15360.0});
}

std::vector<CaseOf<ResponseRow>> limit_cases(bool quick) {
    return cases_over(run_limit, quick ? std::vector{1e2, 1e3} : std::vector{1e1, 1e2, 1e3, 1e4, 1e5},
                      std::vector{0.0, 0.5, 1.0});
}

std::vector<Chart> step_charts(const ResponseRows& rows) {
    const auto responses = words_of(rows, [](const ResponseRow& row) { return name_of(row.response); });
    return {{"responses",
             "responses",
             "A sheet that falls onto the ground, by its step: the errors of the time of the impact and of the height "
             "to which it bounces; and how fast a sheet drifts that should stick to a slope.",
             {{"responses", in_words(responses)}}}};
}

std::vector<Chart> limit_charts(const ResponseRows&) {
    return {{"responses_limit",
             "responses_limit",
             "The longest step at which a penalty does not throw off a sheet that rests on it, against its stiffness: "
             "lines as predicted, points as measured.",
             {}}};
}

}  // namespace

Experiment responses_experiment() {
    using Row = ResponseRow;
    return ExperimentOf<Row>{
        "responses",
        "which response is right, and at which step?",
        {5,
         {{word_column("part", {"step", "limit"}), &Row::part},
          {name_column<ResponseKind>("response"), &Row::response},
          {positive_column("step_s").or_nan(), &Row::step},
          {number_column("impact_error_s").or_nan(), &Row::impact_error},
          {number_column("height_error").or_nan(), &Row::height_error},
          {number_column("drift_m_per_s").or_nan(), &Row::drift},
          {number_column("sweeps").or_nan(), &Row::sweeps},
          {number_column("respond_s").or_nan(), &Row::cost},
          {positive_column("stiffness_N_per_m").or_nan(), &Row::stiffness},
          {number_column("restitution").or_nan(), &Row::restitution},
          {positive_column("predicted_step_s").or_nan(), &Row::predicted},
          {positive_column("measured_step_s").or_nan(), &Row::measured}}},
        {{"part", "response", "step_s", "stiffness_N_per_m", "restitution"},
         {"impact_error_s", "height_error", "drift_m_per_s", "predicted_step_s", "measured_step_s"}},
        {{"step", step_cases, step_charts}, {"limit", limit_cases, limit_charts}}};
}

}  // namespace drape
