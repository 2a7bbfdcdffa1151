#pragma once
#include "report/report.h"

#include <filesystem>
#include <string>
#include <vector>

namespace testat {
/// A tutor's word against the grader's. Of overrides.json: a list of objects with these keys.
struct Override {
    std::string student;   ///< name of the report's folder; of a team the folder of any member
    std::string function;  ///< bare name, or "total"
    double points = 0;
    std::string reason;
    std::string who;
    std::string when;  ///< ISO 8601
};

/// Empty if there is no such file. Throws BadJson naming entry and key if it is not as it should be.
std::vector<Override> read_overrides(std::filesystem::path const& file);

/// The report with what the tutors have given whoever has one of these names: functions, tasks and points follow, and
/// each changed place says so under `override`. A function's points count within the sheet's rules for whole files;
/// "total" is the last word. Throws std::invalid_argument if there is no such function or it is worth less than that.
Report apply(std::vector<Override> const& overrides, std::vector<std::string> const& names, Report report);
}  // namespace testat
