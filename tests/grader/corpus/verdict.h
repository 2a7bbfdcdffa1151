#pragma once
#include "end_to_end/testat_program.h"

#include <algorithm>

/// The first line of a file of the corpus says how it must be graded:
///   // verdict: {"loses": {"wrap_repeat": [0.5, 1]}, "says": {"wrap_repeat": "partial"},
///                "mistake": {"wrap_repeat": "repeat_abs"}, "policy": [], "prints": []}      (on one line)
/// loses: points that functions lose before policy, from and to; every other function has all of its points.
/// says: their words in report.json; every other function is "correct".
/// mistake: how their mistakes are called; no other function's is named.
/// policy: what of the sheet's policies applies; none if it is left out.
/// prints: functions whose checks must say that they print.
/// by_hand: what GRADING's table of mistakes leaves of the points before policy, worked out without the grader.
namespace testat {
inline Json read_verdict(std::filesystem::path const& file)
{
    std::string const mark = "// verdict: ";
    std::string const text = read_file(file);
    std::string const line = text.substr(0, text.find('\n'));
    std::size_t const at = line.find(mark);
    if (at == std::string::npos)
        throw std::runtime_error(file.string() + ": line 1 holds no verdict");
    return Json::parse(line.substr(at + mark.size()));
}

/// The composed files of a kind, "correct" or "wrong", by name.
inline std::vector<std::filesystem::path> corpus_files(std::string const& kind)
{
    std::vector<std::filesystem::path> files;
    for (auto const& entry : std::filesystem::directory_iterator(std::filesystem::path(TESTAT_CORPUS) / kind))
        files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}
}  // namespace testat
