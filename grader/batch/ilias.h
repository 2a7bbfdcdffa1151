#pragma once
#include "batch/batch.h"

/// What ILIAS takes back (FORMATS.md names the layouts).
namespace testat {
/// A zip for "multi feedback": multi_feedback_<title>_<assignment>/<user folder>/testat.html for every student, of a
/// team for every member. The pages are those in `reports`, report.html in a folder for each student. The same entries
/// give the same bytes. Throws std::runtime_error if it cannot be written.
void write_feedback_zip(std::vector<GradedUpload> const& entries, std::filesystem::path const& reports,
                        std::string const& title, std::string const& assignment, std::filesystem::path const& file);

/// The status sheet, columns by position as the plugin wants them; update is 1 for what was graded, 0 elsewhere. Teams
/// have a sheet of another shape: `of_teams` chooses which entries are in it. Throws std::runtime_error.
void write_status_sheet(std::vector<GradedUpload> const& entries, bool of_teams, Language language,
                        std::filesystem::path const& file);

/// "notgraded", "passed" or "failed".
std::string ilias_status(Report const& report);
}  // namespace testat
