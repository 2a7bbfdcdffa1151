#pragma once
#include "batch/executor.h"
#include "batch/intake.h"
#include "report/text.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// `testat batch INPUT --out DIR`: many uploads, graded by processes of `testat grade`, and what tutors make of it.
namespace testat {
struct BatchOptions {
    std::filesystem::path input;
    std::filesystem::path out;
    Executor executor = Executor::local;
    std::size_t at_once = 1;
    std::string deadline;  ///< ISO 8601; empty: the rubric's
    bool resume = true;    ///< results of before count
    bool apply = false;    ///< changed points are written
    bool similarity = false;
    std::vector<std::filesystem::path> earlier;  ///< inputs of other years, for similarity
    std::string assignment = "0";                ///< ILIAS's number of the exercise, for the feedback's zip
    GradeSettings settings;
    Language language = Language::en;
};

/// One upload and its report, with what tutors have given.
struct GradedUpload {
    Upload upload;
    std::string key;  ///< of its result in the store
    Report report;
    std::string graded = "-";  ///< points before tutors gave theirs
    bool is_graded() const { return report.at("status") == "graded"; }
};

/// Grades what has not been graded, and writes into `out`: reports/<student>/, grades.csv, junit.xml, summary.txt.
/// Nothing is written over that is not a batch's own. Returns whether all were gradable. Throws std::invalid_argument
/// for wrong usage, Interrupted on Ctrl-C, std::runtime_error when something of ours fails.
bool batch(BatchOptions const& options);

/// A row for each entry: who, when, points by function, mistakes, overrides.
std::string grades_table(std::vector<GradedUpload> const& entries);

/// How the batch came out, for tutors.
std::string summary(std::vector<GradedUpload> const& entries, std::vector<std::string> const& remarks,
                    Language language);
}  // namespace testat
