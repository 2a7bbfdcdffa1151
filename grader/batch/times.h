#pragma once
#include <cstdint>
#include <optional>
#include <string>

/// Points in time, in seconds since 1970. What has no offset is local time.
namespace testat {
/// "2026-11-24T23:59", also with seconds, with a space for the T, with an offset ("Z", "+01:00", "-0500"); the date
/// alone is the end of that day. Nothing if it is none of these or no such day.
std::optional<std::int64_t> parse_iso_time(std::string const& text);

/// The same for the command line. Throws std::invalid_argument saying what is understood.
std::int64_t parse_deadline(std::string const& text);

/// A cell of a spreadsheet: Excel's days since 1899-12-30 (only from 2000 to 2100, to tell them from other numbers),
/// ISO, "24.11.2026 23:59", "24. Nov 2026, 23:59" in German or English.
std::optional<std::int64_t> parse_cell_time(std::string const& text);
}  // namespace testat
