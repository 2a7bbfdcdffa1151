#pragma once
#include "report/report.h"

#include <string>

namespace testat {
enum class Language { de, en };

/// The report for people: points by task and function, then the first mistake of each function with input, measured
/// value and hint, then the pictures that differ. 80 columns where the content allows. `expected` values are shown if
/// the report has them.
std::string report_to_text(Report const& report, Language language);
}  // namespace testat
