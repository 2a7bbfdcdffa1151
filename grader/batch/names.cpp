#include "batch/names.h"

#include "text.h"

#include <algorithm>
#include <regex>
#include <vector>

namespace testat {
namespace {
constexpr std::size_t max_bytes = 150;
constexpr std::size_t max_extension = 10;  // bytes
constexpr std::size_t longest_letter =
    6;  // of ASCII that one letter becomes: "zhuang"; UTF-8 as underscores is shorter

bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

bool is_kept(char c)
{
    return is_digit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

bool is_continuation(char c)
{
    return (static_cast<unsigned char>(c) & 0xc0) == 0x80;
}

char lower_case(char c)
{
    return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
}

/// At most so many bytes, cut between two characters.
std::string cut(std::string const& text, std::size_t bytes)
{
    if (text.size() <= bytes)
        return text;
    while (bytes > 0 && is_continuation(text[bytes]))
        --bytes;
    return text.substr(0, bytes);
}

/// How much of a text can have been read after a letter, from what can have been read before.
std::vector<bool> read_letter(std::vector<bool> const& before, std::string_view text, char letter)
{
    std::vector<bool> after(before.size());
    for (std::size_t i = 0; i < before.size(); ++i)
        if (before[i] && is_kept(letter) && i < text.size())
            after[i + 1] = after[i + 1] || lower_case(text[i]) == lower_case(letter);
        else if (before[i] && !is_kept(letter))
            std::fill_n(after.begin() + std::ptrdiff_t(i), std::min(longest_letter + 1, after.size() - i), true);
    return after;
}
}  // namespace

std::string lower_case(std::string text)
{
    std::transform(text.begin(), text.end(), text.begin(), [](char c) { return lower_case(c); });
    return text;
}

std::optional<UserFolder> parse_user_folder(std::string const& folder)
{
    std::size_t const last = folder.rfind('_');
    if (last == std::string::npos || last == 0 || last + 1 == folder.size() || folder.size() > 1000)
        return std::nullopt;
    UserFolder result{folder.substr(0, last), folder.substr(last + 1)};
    bool const has_names = std::count(result.person.begin(), result.person.end(), '_') >= 2;
    bool const has_id = std::all_of(result.usr_id.begin(), result.usr_id.end(), is_digit);
    if (!has_names || !has_id || result.usr_id.size() > 18)
        return std::nullopt;
    return result;
}

std::optional<std::string> parse_team(std::string const& folder)
{
    static std::regex const team("(?:team|gruppe|group)[ _]([0-9]{1,18})", std::regex::icase);
    std::smatch match;
    if (folder.size() > 50 || !std::regex_match(folder, match, team))
        return std::nullopt;
    return match[1].str();
}

FileName parse_file_name(std::string const& name)
{
    constexpr std::string_view extension = ".cpp";
    FileName result;
    std::string stem = lower_case(name);
    if (stem.size() < extension.size() ||
        stem.compare(stem.size() - extension.size(), extension.size(), extension) != 0)
        return result;
    result.is_source = true;
    stem.resize(stem.size() - extension.size());

    // "exercise_03 - my final.cpp" is not late.
    if (std::size_t const dash = stem.rfind(" - "); dash != std::string::npos && dash > 0) {
        result.is_late = stem.rfind("exercise_03", 0) != 0;
        stem.erase(0, result.is_late ? dash + 3 : 0);
    }
    if (std::size_t const open = stem.rfind('('); open != std::string::npos && open > 0 && stem.back() == ')') {
        std::string const digits = stem.substr(open + 1, stem.size() - open - 2);
        if (!digits.empty() && digits.size() < 9 && std::all_of(digits.begin(), digits.end(), is_digit)) {
            result.number = std::stoi(digits);
            stem.resize(stem[open - 1] == ' ' ? open - 1 : open);
        }
    }
    result.is_expected = stem == "exercise_03" || stem == "03";
    return result;
}

bool may_be(std::string_view person, std::string const& lastname, std::string const& firstname,
            std::string const& login)
{
    std::vector<bool> read(person.size() + 1);
    read[0] = true;
    for (char letter : lastname + "_" + firstname + "_" + login)
        if (!is_continuation(letter))
            read = read_letter(read, person, letter);
    return read.back();
}

std::string safe_file_name(std::string const& name)
{
    std::string safe = one_line(name, 4096);
    std::replace_if(
        safe.begin(), safe.end(), [](char c) { return std::string_view("/\\<>:\"|?*").find(c) != std::string::npos; },
        '_');
    std::size_t const dot = safe.rfind('.');
    std::string const extension =
        dot != std::string::npos && safe.size() - dot <= max_extension ? safe.substr(dot) : "";
    safe = cut(safe.substr(0, safe.size() - extension.size()), max_bytes - extension.size()) + extension;
    while (!safe.empty() && (safe.back() == '.' || safe.back() == ' '))
        safe.pop_back();
    if (safe.empty() || safe[0] == '.' || safe[0] == '-')
        safe.insert(0, "_");
    return safe;
}

std::string UniqueNames::add(std::string const& name)
{
    std::string unique = name;
    for (int i = 2; !taken_.insert(lower_case(unique)).second; ++i)
        unique = name + " (" + std::to_string(i) + ")";
    return unique;
}
}  // namespace testat
