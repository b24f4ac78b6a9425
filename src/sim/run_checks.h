#pragma once

#include <initializer_list>
#include <string>

#include "drape/sim/contact_search.h"
#include "drape/sim/step_report.h"

namespace drape {

/// Marks in the report that in a substep at a time, of length h [s], something may have passed through the cloth
/// unseen.
void mark_crossing(const Crossing& crossing, double time, Real h, StepReport& report);

/// Clauses with semicolons between, but for those that are empty.
std::string joined(std::initializer_list<std::string> clauses);

}  // namespace drape
