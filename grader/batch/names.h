#pragma once
#include <optional>
#include <set>
#include <string>
#include <string_view>

/// What names in an ILIAS download say.
namespace testat {
/// <Lastname>_<Firstname>_<login>_<usr_id>; names and logins may have underscores, so only the end is certain.
struct UserFolder {
    std::string person;  ///< what comes before the usr_id
    std::string usr_id;  ///< digits
};

/// Nothing if it is no such name.
std::optional<UserFolder> parse_user_folder(std::string const& folder);

/// "17" of "Team 17"; nothing if it is no team's folder.
std::optional<std::string> parse_team(std::string const& folder);

struct FileName {
    bool is_source = false;    ///< ends with .cpp
    bool is_late = false;      ///< "<text> - exercise_03.cpp"
    bool is_expected = false;  ///< exercise_03.cpp, or 03.cpp as ILIAS may cut it, late or not, numbered or not
    int number = 1;            ///< 2 of "exercise_03 (2).cpp"
};

FileName parse_file_name(std::string const& name);

/// Whether ILIAS may have made the folder `person` of that name and login: letters and digits of ASCII are kept, the
/// others are transliterated, replaced by underscores or left out, in ways that depend on the version.
bool may_be(std::string_view person, std::string const& lastname, std::string const& firstname,
            std::string const& login);

/// The name as that of one file on any system: no separators, no hidden file, at most 150 bytes; its extension stays.
std::string safe_file_name(std::string const& name);

/// Hands out names that also differ where case does not count.
class UniqueNames {
public:
    /// The name, or if it is taken, with " (2)", " (3)", ...
    std::string add(std::string const& name);

private:
    std::set<std::string> taken_;
};

/// A to Z in lower case; everything else as it is.
std::string lower_case(std::string text);
}  // namespace testat
