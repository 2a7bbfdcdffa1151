#pragma once
#include "report/report.h"
#include "report/text.h"
#include "stress/stress.h"

/// What `testat stress` writes.
namespace testat {
/// stress.json: grader/REPORT.md says what its keys mean. NaN and infinity are null.
Report stress_to_json(Submission const& submission, Build const& build, StressOptions const& options,
                      std::vector<FunctionStress> const& results);

/// For people: a table, the worst input of each function, and what happened outside of the contract.
std::string stress_to_text(Report const& document, Language language);

/// A picture for people, one row for each function: where the errors lie, in units of the allowed bound. SVG without
/// anything from elsewhere.
std::string stress_to_svg(std::vector<FunctionStress> const& results, std::string const& file, Language language);
}  // namespace testat
