#pragma once
#include "report/report.h"
#include "report/text.h"

#include <string>

namespace testat {
/// What a save has changed, for people, in a few lines: points and what they were before, functions that gained or
/// lost, then the first compiler's message, or the first mistake in the order of the sheet. Both are graded; `before`
/// is null at first.
std::string changes_to_text(Report const* before, Report const& after, Language language);
}  // namespace testat
