#pragma once
#include "bench/bench.h"
#include "report/report.h"
#include "report/text.h"

/// What `testat bench` writes.
namespace testat::bench {
/// bench.json: grader/REPORT.md says what its keys mean. What is not known or not finite is null. `submission` and
/// `build` are null without an upload.
Report bench_to_json(BenchResults const& results, Submission const* submission, Build const* build);

/// For people: a table of time and errors, what became of the two promises, float errors.
std::string bench_to_text(Report const& document, Language language);

/// A picture for people: time against error for each pattern with its Pareto front, and float errors by the size of u.
/// `file`: the upload's name, or empty. SVG without anything from elsewhere.
std::string bench_to_svg(BenchResults const& results, std::string const& file, Language language);
}  // namespace testat::bench
