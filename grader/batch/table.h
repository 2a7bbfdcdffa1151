#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// The xlsx in an ILIAS download: who has handed in, and when. It has no usr_id, and its headings, whose order and
/// language vary, are not relied on: columns are found by what is in them.
namespace testat {
/// The first sheet's cells as text, row by row; dates are Excel's numbers.
using Rows = std::vector<std::vector<std::string>>;

/// Unpacks into `scratch`, which must not exist or be empty. Throws std::invalid_argument if it is damaged.
Rows read_xlsx(std::filesystem::path const& xlsx, std::filesystem::path const& scratch);

/// xl/worksheets/sheet1.xml with xl/sharedStrings.xml, which may be empty. At most 10,000 rows of 30 columns, 300 bytes
/// a cell; the rest is cut off. Throws std::invalid_argument if one is no XML.
Rows read_sheet(std::string const& sheet, std::string const& strings);

struct Submitter {
    std::string lastname, firstname, login;  ///< as they are, not transliterated
    std::optional<std::int64_t> submitted;   ///< seconds since 1970
};

struct Joined {
    std::vector<std::optional<Submitter>> submitters;  ///< in the order of `persons`; nothing where no row fits
    std::vector<Submitter> without_folder;             ///< rows that fit nobody; empty if no row fits anybody
};

/// Whose row is whose: `persons` are names of user folders without usr_id. Of several rows the latest time counts.
Joined join(Rows const& rows, std::vector<std::string> const& persons);
}  // namespace testat
