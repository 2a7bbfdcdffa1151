#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// From what a tutor has downloaded to a list of uploads.
namespace testat {
/// One student's upload, or one team's.
struct Upload {
    /// Names the report's folder, so it is a safe file name that differs from all others: the user folder as exported
    /// (of a team the one with the newest file), in a flat folder the file's name without .cpp, or its folder's name.
    std::string student;
    std::string lastname, firstname, login;    ///< as far as known: from the xlsx, else from an unambiguous user folder
    std::string usr_id;                        ///< digits; empty in a flat folder
    std::string team;                          ///< digits; empty without teams
    std::string folder;                        ///< the user folder, as exported; empty in a flat folder
    std::vector<std::string> members;          ///< the user folders of a team, as exported; empty without teams
    std::vector<std::string> logins;           ///< of a team's members, as far as the xlsx has them
    std::filesystem::path file;                ///< the newest
    std::vector<std::filesystem::path> older;  ///< the others, newest first
    std::optional<std::int64_t> submitted;     ///< seconds since 1970: from the xlsx, else the file's time
    bool late = false;                         ///< after the deadline, or marked late by ILIAS
};

struct Intake {
    std::string title;  ///< of the exercise; of a flat folder its name
    bool is_ilias = false;
    std::vector<Upload> uploads;       ///< in the order of `student`
    std::vector<std::string> remarks;  ///< for the tutor: students without a file, what was left out and why
};

/// Reads an ILIAS download (a zip, or a folder in that layout from any level on), or a flat folder or zip of .cpp files
/// or of folders with one each. Zips are unpacked into `scratch`, which must not exist or be empty; otherwise `scratch`
/// is used for the xlsx only, and files stay where they are. `deadline`: seconds since 1970; who is later, is late.
///
/// Throws std::invalid_argument, saying what is wrong, where, and what to do, if there is no such file, for a damaged
/// or hostile zip, and for what is none of these; std::runtime_error if `scratch` cannot be written.
Intake take_in(std::filesystem::path const& input, std::filesystem::path const& scratch,
               std::optional<std::int64_t> deadline);
}  // namespace testat
