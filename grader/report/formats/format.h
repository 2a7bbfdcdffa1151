#pragma once
#include "report/report.h"
#include "report/text.h"

#include <functional>
#include <string>
#include <vector>

/// Reports in other shapes: each format is a pure function of reports, and at most the pictures beside them, to a text.
namespace testat {
/// A report, and whose it is: the names that tell several apart.
struct NamedReport {
    std::string name;  ///< of the folder it lies in
    Report report;
    std::filesystem::path folder = {};  ///< where report.json lies; its pictures are below
};

struct Format {
    std::string name;         ///< as in --format
    std::string file;         ///< where `grade` writes it, beside report.json
    bool takes_many = false;  ///< or exactly one report
    std::string (*write)(std::vector<NamedReport> const& reports, Language language);
};

/// csv, gradescope, html, junit, sarif.
std::vector<Format> const& formats();

/// One row for each report: points by function, then whether each check has passed (1, 0, nothing if it was not asked).
/// A header first; RFC 4180; no cell can be taken for a formula.
std::string to_csv(std::vector<NamedReport> const& reports, Language language);

/// results.json of a Gradescope autograder; one test for each function. What is not gradable has no score.
std::string to_gradescope(std::vector<NamedReport> const& reports, Language language);

/// A page for people, in both languages, that needs nothing but itself; what an upload put into the report is text in
/// it and nothing else. Below 8 MB. `language` is the one it begins with.
std::string to_html(std::vector<NamedReport> const& reports, Language language);

/// One suite; a test case for each check and each picture. A crash or time-out is an error, a wrong answer a failure.
std::string to_junit(std::vector<NamedReport> const& reports, Language language);

/// SARIF 2.1.0: messages of the compiler, and each function that lost points, on its line of the upload.
std::string to_sarif(std::vector<NamedReport> const& reports, Language language);

/// What the failure of a function of a graded report is about, in a few lines: its mistake, the first failed check with
/// input, measured and (if the report has it) expected value, or else the pictures that are not right. Empty if nothing
/// has failed.
std::string explain_function(Report const& report, std::string const& name, Language language);

/// "a: b" for a check's words in one language.
std::string explain_check(Report const& check, Language language);
}  // namespace testat
