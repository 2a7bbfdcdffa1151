#pragma once
#include "model.h"
#include "rubric/rubric.h"

#include <nlohmann/json.hpp>

/// report.json as a document: grader/REPORT.md is the contract, references/report.schema.json its schema.
namespace testat {
/// Keys keep the order of the contract.
using Report = nlohmann::ordered_json;

struct ReportOptions {
    bool for_tutor = true;  ///< students do not see what would have been right
    bool sandbox = true;    ///< the file was compiled and run in the cage
};

struct TestSet {
    std::string version;
    std::string sha256;
    std::uint64_t seed = 0;
};

/// Stages' milliseconds; the only parts that differ between two runs are this and run_time.
struct Timing {
    double compile_ms = 0;
    double observe_ms = 0;
    double check_ms = 0;
    double total_ms = 0;
};

/// Everything the pipeline has found, as a report with status "graded".
Report make_report(Submission const& submission, Build const& build, CheckResults const& results, Grade const& grade,
                   Rubric const& rubric, TestSet const& test_set, Timing const& timing, ReportOptions const& options);

/// Status "not_gradable": our fault, so no points at all.
Report make_not_gradable(Submission const& submission, TestSet const& test_set, std::string const& error);

/// JSON text of the document, numbers as short as they can be, ending with a newline.
std::string to_text(Report const& report);

/// Makes what --out names. Throws std::invalid_argument if it cannot be made or written to.
void make_output_directory(std::filesystem::path const& directory);

/// Throws std::runtime_error naming the file.
void write_file(std::filesystem::path const& file, std::string const& bytes);

/// Replaces the file as a whole: temporary file beside it, fsync, rename. Throws std::runtime_error and leaves the old
/// one in place when that fails.
void write_atomically(std::filesystem::path const& file, std::string const& bytes);

/// The JSON object in a file of our own; an empty one if there is none.
Report read_if_there(std::filesystem::path const& file);

/// Reads and validates a report.json. Throws std::runtime_error naming file and place.
Report read_report(std::filesystem::path const& file, std::filesystem::path const& schema);
}  // namespace testat
