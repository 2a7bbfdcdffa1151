#include "batch/times.h"

#include "text.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstring>
#include <ctime>
#include <regex>
#include <stdexcept>

namespace testat {
namespace {
/// Days since 1970-01-01 in Excel's count.
constexpr double excel_1970 = 25569;
constexpr double excel_2000 = 36526;
constexpr double excel_2100 = 73051;
constexpr std::size_t longest = 60;  // bytes of any such text

struct Civil {
    int year = 0, month = 0, day = 0, hour = 0, minute = 0, second = 0;
};

int number(std::ssub_match const& digits)
{
    return digits.matched ? std::stoi(digits.str()) : 0;
}

std::tm to_tm(Civil const& civil)
{
    std::tm tm{};
    tm.tm_year = civil.year - 1900;
    tm.tm_mon = civil.month - 1;
    tm.tm_mday = civil.day;
    tm.tm_hour = civil.hour;
    tm.tm_min = civil.minute;
    tm.tm_sec = civil.second;
    tm.tm_isdst = -1;
    return tm;
}

bool exists(Civil const& civil)
{
    std::tm day = to_tm({civil.year, civil.month, civil.day});
    timegm(&day);
    bool const is_day = day.tm_mday == civil.day && day.tm_mon == civil.month - 1 && civil.year >= 1900;
    return is_day && civil.hour < 24 && civil.minute < 60 && civil.second < 60;
}

std::optional<std::int64_t> local(Civil const& civil)
{
    if (!exists(civil))
        return std::nullopt;
    std::tm tm = to_tm(civil);
    return std::mktime(&tm);
}

/// "+01:00" in seconds, "Z" as 0; nothing if there is no such offset.
std::optional<std::int64_t> offset_of(std::string const& text)
{
    if (text == "Z" || text == "z")
        return 0;
    int const hours = std::stoi(text.substr(1, 2));
    int const minutes = std::stoi(text.substr(text.size() - 2));
    if (hours > 14 || minutes > 59)
        return std::nullopt;
    return (text[0] == '-' ? -1 : 1) * (hours * 3600 + minutes * 60);
}

std::optional<std::int64_t> parse_excel(std::string const& text)
{
    char* end = nullptr;
    double const days = std::strtod(text.c_str(), &end);
    if (end == text.c_str() || *end != '\0' || !(days >= excel_2000 && days < excel_2100))
        return std::nullopt;
    // The count is of local time, so it is taken apart as if it were UTC, and put together as what it is.
    std::time_t const seconds = std::llround((days - excel_1970) * 86400);
    std::tm tm{};
    gmtime_r(&seconds, &tm);
    tm.tm_isdst = -1;
    return std::mktime(&tm);
}

/// From its first three letters, German or English; 0 if it is none.
int month_of(std::string const& name)
{
    constexpr std::array<char const*, 12> names = {"jan", "feb", "mar mär mrz", "apr",     "mai may", "jun",
                                                   "jul", "aug", "sep",         "okt oct", "nov",     "dez dec"};
    std::string word = name.substr(0, name.rfind("m\xc3", 0) == 0 || name.rfind("M\xc3", 0) == 0 ? 4 : 3);
    if (word.size() < 3)
        return 0;
    for (char& c : word)
        c = c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
    for (std::size_t i = 0; i < names.size(); ++i)
        if (std::strstr(names[i], word.c_str()) != nullptr)
            return int(i) + 1;
    return 0;
}

std::optional<std::int64_t> parse_written(std::string const& text)
{
    static std::regex const written(
        R"(([0-9]{1,2})\. ?([0-9]{1,2}|[^0-9 .,]{3,12})[. ] ?([0-9]{4}),? +([0-9]{1,2}):([0-9]{2})(?::([0-9]{2}))?.{0,5})");
    std::smatch match;
    if (!std::regex_match(text, match, written))
        return std::nullopt;
    std::string const month = match[2];
    bool const in_digits = month[0] >= '0' && month[0] <= '9';
    return local({number(match[3]), in_digits ? std::stoi(month) : month_of(month), number(match[1]), number(match[4]),
                  number(match[5]), number(match[6])});
}
}  // namespace

std::optional<std::int64_t> parse_iso_time(std::string const& text)
{
    static std::regex const iso(
        R"(([0-9]{4})-([0-9]{2})-([0-9]{2})(?:[T ]([0-9]{2}):([0-9]{2})(?::([0-9]{2}))?(Z|z|[+-][0-9]{2}:?[0-9]{2})?)?)");
    std::smatch match;
    if (text.size() > longest || !std::regex_match(text, match, iso))
        return std::nullopt;
    Civil civil{number(match[1]), number(match[2]), number(match[3]),
                number(match[4]), number(match[5]), number(match[6])};
    if (!match[4].matched)
        civil = {civil.year, civil.month, civil.day, 23, 59, 59};
    if (!match[7].matched)
        return local(civil);
    auto const offset = offset_of(match[7]);
    if (!exists(civil) || !offset)
        return std::nullopt;
    std::tm tm = to_tm(civil);
    return timegm(&tm) - *offset;
}

std::int64_t parse_deadline(std::string const& text)
{
    if (auto const time = parse_iso_time(text))
        return *time;
    throw std::invalid_argument(
        fmt::format("'{}' is not a time. Write it as 2026-11-24T23:59 (local time) or "
                    "2026-11-24T23:59+01:00.",
                    one_line(text, 100)));
}

std::optional<std::int64_t> parse_cell_time(std::string const& text)
{
    if (text.empty() || text.size() > longest)
        return std::nullopt;
    if (auto const time = parse_excel(text))
        return time;
    if (auto const time = parse_iso_time(text))
        return time;
    return parse_written(text);
}
}  // namespace testat
