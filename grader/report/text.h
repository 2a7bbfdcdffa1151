#pragma once
#include "report/report.h"

#include <string>

namespace testat {
enum class Language { de, en };

/// With colours only where somebody looks at a terminal.
enum class Ink { plain, coloured };

/// The report for people: points, and what to fix first; points by task and function, then the first mistake of each
/// function with input, measured value and hint, then the pictures that differ. 80 columns where the content allows.
/// `expected` values are shown if the report has them.
std::string report_to_text(Report const& report, Language language, Ink ink = Ink::plain);

/// Colours if stdout is a terminal that knows them, and NO_COLOR (no-color.org) is not set.
Ink ink_of_stdout();
}  // namespace testat
