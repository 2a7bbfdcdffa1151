// Checks what a batch has written for ILIAS, feedback.zip and the status sheets: whether ILIAS takes it, and whether it
// agrees with the download and with grades.csv. It knows the formats and nothing of how the batch writes them.
#include "batch/table.h"
#include "process/run.h"

#include <archive.h>
#include <archive_entry.h>
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <clocale>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <memory>
#include <regex>
#include <set>

namespace fs = std::filesystem;

namespace testat {
namespace {
using Names = std::vector<std::string>;

class Complaints {
public:
    template <typename... Values>
    void add(fmt::format_string<Values...> text, Values&&... values)
    {
        ++count_;
        fmt::print("  {}\n", fmt::format(text, std::forward<Values>(values)...));
    }
    std::size_t count() const { return count_; }

private:
    std::size_t count_ = 0;
};

// --- Zips ------------------------------------------------------------------------------------------------------------

struct Item {
    std::string name;
    bool is_file = false;
    std::string bytes;
};

std::string contents_of(archive* zip)
{
    std::string bytes;
    char buffer[1 << 16];
    la_ssize_t read = 0;
    while ((read = archive_read_data(zip, buffer, sizeof buffer)) > 0)
        bytes.append(buffer, std::size_t(read));
    if (read < 0)
        throw std::runtime_error(archive_error_string(zip));
    return bytes;
}

std::vector<Item> read_zip(fs::path const& file)
{
    std::unique_ptr<archive, int (*)(archive*)> const zip(archive_read_new(), archive_read_free);
    archive_read_support_format_zip_seekable(zip.get());
    if (archive_read_open_filename(zip.get(), file.c_str(), 1 << 16) != ARCHIVE_OK)
        throw std::runtime_error(file.string() + ": " + archive_error_string(zip.get()));
    std::vector<Item> items;
    archive_entry* entry = nullptr;
    int result = ARCHIVE_OK;
    while ((result = archive_read_next_header(zip.get(), &entry)) >= ARCHIVE_WARN && result != ARCHIVE_EOF) {
        char const* const name = archive_entry_pathname(entry);
        bool const is_file = archive_entry_filetype(entry) == AE_IFREG;
        items.push_back({name == nullptr ? "" : name, is_file, is_file ? contents_of(zip.get()) : ""});
    }
    if (result != ARCHIVE_EOF)
        throw std::runtime_error(file.string() + ": " + archive_error_string(zip.get()));
    return items;
}

/// Empty parts are kept: "a//b" has three.
Names parts(std::string const& name)
{
    Names all(1);
    for (char c : name)
        if (c == '/')
            all.emplace_back();
        else
            all.back() += c;
    return all;
}

// --- The download ----------------------------------------------------------------------------------------------------

struct User {
    std::string usr_id, team;
    std::string lastname, firstname, login;  ///< of the xlsx; empty if it has no such row
    std::set<std::string> files;
};

struct Download {
    std::string title;
    std::map<std::string, User> users;  ///< by folder
};

std::size_t column(Rows const& rows, std::regex const& heading)
{
    auto const& headings = rows.at(0);
    auto const found = std::find_if(headings.begin(), headings.end(),
                                    [&](std::string const& cell) { return std::regex_match(cell, heading); });
    if (found == headings.end())
        throw std::runtime_error("the download's xlsx lacks a column");
    return std::size_t(found - headings.begin());
}

/// The login is what stands before the usr_id; of two that fit, the longer one.
void add_names(Rows const& rows, std::map<std::string, User>& users)
{
    std::size_t const last = column(rows, std::regex("Nachname|Last ?name", std::regex::icase));
    std::size_t const first = column(rows, std::regex("Vorname|First ?name", std::regex::icase));
    std::size_t const login = column(rows, std::regex("Benutzername|Login", std::regex::icase));
    for (auto& [folder, user] : users) {
        std::string const person = folder.substr(0, folder.rfind('_'));
        for (auto row = rows.begin() + 1; row != rows.end(); ++row) {
            if (row->size() <= std::max({last, first, login}) || row->at(login).size() <= user.login.size())
                continue;
            std::string const end = "_" + row->at(login);
            if (person.size() > end.size() && person.compare(person.size() - end.size(), end.size(), end) == 0) {
                user.lastname = row->at(last);
                user.firstname = row->at(first);
                user.login = row->at(login);
            }
        }
    }
}

Rows rows_of(std::string const& xlsx)
{
    TemporaryDirectory const place;
    std::ofstream(place.path() / "table.xlsx", std::ios::binary) << xlsx;
    return read_xlsx(place.path() / "table.xlsx", place.path() / "unpacked");
}

/// <Title>/<Title>.xlsx, <Title>/<word>/[Team <number>/]<user folder>/<file>
Download read_download(fs::path const& file)
{
    static std::regex const team("Team ([0-9]+)"), user_folder(".+_([0-9]+)");
    Download download;
    std::string table;
    for (auto const& item : read_zip(file)) {
        Names const path = parts(item.name);
        std::smatch match;
        bool const in_team = path.size() > 2 && std::regex_match(path[2], match, team);
        std::size_t const at = in_team ? 3 : 2;
        if (path.size() == 2 && item.is_file)
            table = item.bytes;
        if (path.size() <= at)
            continue;
        User& user = download.users[path[at]];
        user.team = in_team ? match[1].str() : "";
        if (!std::regex_match(path[at], match, user_folder))
            throw std::runtime_error("the download has a folder that is no user's: " + path[at]);
        user.usr_id = match[1];
        if (item.is_file)
            user.files.insert(path.back());
        download.title = path[0];
    }
    add_names(rows_of(table), download.users);
    return download;
}

// --- grades.csv ------------------------------------------------------------------------------------------------------

struct GradesRow {
    std::string usr_id, team;
    bool graded = false;
    bool passed = false;
    double points = 0;
};

/// RFC 4180.
Rows read_csv(std::string const& text)
{
    Rows rows;
    bool quoted = false, begins = true;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (begins)
            rows.push_back({""});
        begins = false;
        std::string& cell = rows.back().back();
        if (text[i] == '"' && quoted && i + 1 < text.size() && text[i + 1] == '"')
            cell += text[++i];
        else if (text[i] == '"')
            quoted = !quoted;
        else if (text[i] == ',' && !quoted)
            rows.back().emplace_back();
        else if (text[i] == '\n' && !quoted)
            begins = true;
        else if (text[i] != '\r' || quoted)
            cell += text[i];
    }
    return rows;
}

std::string read_text(fs::path const& file)
{
    std::ifstream in(file, std::ios::binary);
    if (!in)
        throw std::runtime_error("cannot read " + file.string());
    return {std::istreambuf_iterator<char>(in), {}};
}

/// "team 7" or "user 12"
std::string key_of(std::string const& usr_id, std::string const& team)
{
    return team.empty() ? "user " + usr_id : "team " + team;
}

/// By student or team.
std::map<std::string, GradesRow> read_grades(fs::path const& file, Complaints& complaints)
{
    Rows const rows = read_csv(read_text(file));
    if (rows.empty())
        throw std::runtime_error(file.string() + " is empty");
    auto const at = [&](char const* name) { return column(rows, std::regex(name)); };
    std::size_t const usr_id = at("usr_id"), team = at("team"), status = at("status"), earned = at("earned"),
                      passed = at("passed_60_percent");
    std::map<std::string, GradesRow> grades;
    for (auto row = rows.begin() + 1; row != rows.end(); ++row) {
        bool const graded = row->at(status) == "graded";
        GradesRow const read{row->at(usr_id), row->at(team), graded, row->at(passed) == "1",
                             graded ? std::stod(row->at(earned)) : 0};
        if (!grades.emplace(key_of(read.usr_id, read.team), read).second)
            complaints.add("grades.csv has {} twice", key_of(read.usr_id, read.team));
    }
    return grades;
}

// --- The feedback's zip ----------------------------------------------------------------------------------------------

/// Of each tag of a page what stands in it, without its script: what is between tags is only text.
Names tags_of(std::string const& html)
{
    Names tags;
    for (std::size_t at = html.find('<'); at != std::string::npos; at = html.find('<', at)) {
        std::size_t const end = html.find('>', at);
        tags.push_back(html.substr(at, end - at));
        at = tags.back().rfind("<script", 0) == 0 ? html.find("</script>", at) : end;
    }
    return tags;
}

/// Whether no attribute of a tag names another file. A picture's bytes are left out: they are long.
bool stands_alone(std::string const& tag)
{
    static std::regex const reference(R"(\s(?:src|href|poster|data|action)\s*=\s*["']?\s*(?!data:|#)[^"'\s>])",
                                      std::regex::icase);
    constexpr std::size_t most = 2000;
    return !std::regex_search(tag.size() < most ? tag : tag.substr(0, tag.find(";base64,")), reference);
}

/// An HTML file that needs nothing else.
bool is_self_contained(std::string const& html)
{
    static std::regex const style(R"(@import|url\(\s*["']?(?!data:|#))", std::regex::icase);
    Names const tags = tags_of(html);
    std::size_t const begin = html.find("<style");
    std::string const css = begin == std::string::npos ? "" : html.substr(begin, html.find("</style", begin) - begin);
    return std::all_of(tags.begin(), tags.end(), stands_alone) && !std::regex_search(css, style);
}

class FeedbackCheck {
public:
    FeedbackCheck(Download const& download, std::map<std::string, GradesRow> const& grades, Complaints& complaints)
        : download_(download), grades_(grades), complaints_(complaints)
    {
    }

    void check(fs::path const& zip, std::string const& assignment)
    {
        for (auto const& item : read_zip(zip))
            check_item(item);
        check_top(assignment);
        for (auto const& [folder, user] : download_.users) {
            auto const row = grades_.find(key_of(user.usr_id, user.team));
            bool const wants = row != grades_.end() && row->second.graded;
            if (wants && files_.count(folder) == 0)
                complaints_.add("{} is graded, but has no feedback", folder);
            if (!wants && files_.count(folder) != 0)
                complaints_.add("{} is not graded, but has feedback", folder);
        }
    }

private:
    void check_item(Item const& item)
    {
        Names const path = parts(item.name);
        if (!item.is_file)
            return complaints_.add("'{}' is no file", item.name);
        if (item.name.find('\\') != std::string::npos)
            complaints_.add("'{}' has a backslash", item.name);
        if (std::any_of(path.begin(), path.end(), [](auto const& part) { return part.empty() || part[0] == '.'; }))
            complaints_.add("'{}' is hidden, or has an empty part", item.name);
        if (path.size() != 3)
            return complaints_.add("'{}' has {} parts instead of 3", item.name, path.size());
        tops_.insert(path[0]);
        auto const user = download_.users.find(path[1]);
        if (user == download_.users.end())
            return complaints_.add("'{}' is for nobody: the download has no such folder", item.name);
        if (!files_.insert(path[1]).second)
            complaints_.add("{} has more than one file", path[1]);
        check_file(item, path[2], user->second);
    }

    void check_file(Item const& item, std::string const& name, User const& user)
    {
        static std::regex const submission(".*\\.(cpp|zip)", std::regex::icase);
        if (user.files.count(name) > 0 || std::regex_match(name, submission))
            complaints_.add("'{}' is named like a submission", item.name);
        if (item.bytes.empty())
            complaints_.add("'{}' is empty", item.name);
        bool const is_html = std::regex_match(name, std::regex(".*\\.html?", std::regex::icase));
        if (is_html && !is_self_contained(item.bytes))
            complaints_.add("'{}' needs other files", item.name);
    }

    /// multi_feedback_<Title_with_underscores>_<number>
    void check_top(std::string const& assignment)
    {
        std::string title = download_.title;
        std::replace(title.begin(), title.end(), ' ', '_');
        std::string const begin = "multi_feedback_" + title + "_";
        if (tops_.size() > 1)
            complaints_.add("there are {} folders at the top", tops_.size());
        for (auto const& top : tops_) {
            std::string const number = top.rfind(begin, 0) == 0 ? top.substr(begin.size()) : "";
            bool const is_number = !number.empty() && number.find_first_not_of("0123456789") == std::string::npos;
            if (!is_number || (!assignment.empty() && number != assignment))
                complaints_.add("the folder at the top is '{}' instead of '{}{}'", top, begin,
                                assignment.empty() ? "<number>" : assignment);
        }
    }

    Download const& download_;
    std::map<std::string, GradesRow> const& grades_;
    Complaints& complaints_;
    std::set<std::string> tops_;
    std::set<std::string> files_;  ///< user folders that have one
};

// --- The status sheets -----------------------------------------------------------------------------------------------

Names const student_headings{"update", "usr_id", "login",   "lastname",   "firstname",   "status",
                             "mark",   "notice", "comment", "plagiarism", "plag_comment"};
Names const team_headings{"update", "team_id", "logins",     "status",      "mark",
                          "notice", "comment", "plagiarism", "plag_comment"};

class StatusCheck {
public:
    StatusCheck(Download const& download, std::map<std::string, GradesRow> const& grades, Complaints& complaints)
        : download_(download), grades_(grades), complaints_(complaints)
    {
    }

    void check_sheet(fs::path const& file)
    {
        TemporaryDirectory const place;
        Rows rows = read_xlsx(file, place.path() / "unpacked");
        bool const of_teams = !rows.empty() && rows[0].size() > 1 && rows[0][1] == "team_id";
        if (rows.empty() || rows[0] != (of_teams ? team_headings : student_headings))
            return complaints_.add("{}: the columns are not those of ILIAS", file.filename().string());
        for (std::size_t i = 1; i < rows.size(); ++i) {
            if (rows[i].size() > rows[0].size())
                complaints_.add("{}, row {}: too many cells", file.filename().string(), i + 1);
            rows[i].resize(rows[0].size());
            check_row(rows[i], of_teams);
        }
    }

    void check_all_are_there()
    {
        for (auto const& [key, row] : grades_)
            if (seen_.count(key) == 0)
                complaints_.add("{} is in grades.csv, but in no status sheet", key);
    }

private:
    void check_row(Names const& cells, bool of_teams)
    {
        std::string const key = of_teams ? key_of("", cells[1]) : key_of(cells[1], "");
        auto const row = grades_.find(key);
        if (row == grades_.end())
            return complaints_.add("{} has a status, but is not in grades.csv", key);
        if (!seen_.insert(key).second)
            complaints_.add("{} has two rows", key);
        if (of_teams)
            check_logins(key, cells[2], cells[1]);
        else
            check_names(key, cells);
        check_status(key, row->second, cells[0], cells[of_teams ? 3 : 5], cells[of_teams ? 4 : 6]);
    }

    void check_names(std::string const& key, Names const& cells)
    {
        for (auto const& [folder, user] : download_.users)
            if (user.team.empty() && user.usr_id == cells[1]) {
                if (Names(cells.begin() + 2, cells.begin() + 5) != Names{user.login, user.lastname, user.firstname})
                    complaints_.add("{}: login and names are not those of the download", key);
                return;
            }
        complaints_.add("{} is not in the download", key);
    }

    void check_logins(std::string const& key, std::string const& logins, std::string const& team)
    {
        static std::regex const separator("[, ;]+");
        std::set<std::string> const named(std::sregex_token_iterator(logins.begin(), logins.end(), separator, -1), {});
        std::set<std::string> members;
        for (auto const& [folder, user] : download_.users)
            if (user.team == team)
                members.insert(user.login);
        if (named != members)
            complaints_.add("{}: the logins are '{}' instead of '{}'", key, logins, fmt::join(members, ", "));
    }

    void check_status(std::string const& key, GradesRow const& grades, std::string const& update,
                      std::string const& status, std::string const& mark)
    {
        std::string const expected = !grades.graded ? "notgraded" : grades.passed ? "passed" : "failed";
        if (status != expected)
            complaints_.add("{}: the status is '{}' instead of '{}'", key, status, expected);
        if (update != (grades.graded ? "1" : "0"))
            complaints_.add("{}: update is '{}'", key, update);
        char* end = nullptr;
        double const points = std::strtod(mark.c_str(), &end);
        bool const agrees = grades.graded ? !mark.empty() && *end == '\0' && points == grades.points : mark.empty();
        if (!agrees)
            complaints_.add("{}: the mark is '{}', but grades.csv says {}", key, mark,
                            grades.graded ? fmt::format("{}", grades.points) : "not graded");
    }

    Download const& download_;
    std::map<std::string, GradesRow> const& grades_;
    Complaints& complaints_;
    std::set<std::string> seen_;
};

std::size_t check(fs::path const& download_file, fs::path const& folder, std::string const& assignment)
{
    Complaints complaints;
    Download const download = read_download(download_file);
    auto const grades = read_grades(folder / "grades.csv", complaints);
    FeedbackCheck(download, grades, complaints).check(folder / "feedback.zip", assignment);
    StatusCheck status(download, grades, complaints);
    for (char const* name : {"status.xlsx", "status_teams.xlsx"})
        if (fs::exists(folder / name))
            status.check_sheet(folder / name);
    status.check_all_are_there();
    fmt::print("{} students and teams, {} complaints\n", grades.size(), complaints.count());
    return complaints.count();
}
}  // namespace
}  // namespace testat

int main(int argc, char** argv)
{
    std::setlocale(LC_CTYPE, "C.UTF-8");  // names in zips are UTF-8
    std::filesystem::path download, folder;
    std::string assignment;
    CLI::App app("Checks feedback.zip and status.xlsx of a batch. Exit: 0 ILIAS takes them, 1 not.", "check_feedback");
    app.add_option("DOWNLOAD", download, "The zip that was graded")->required()->check(CLI::ExistingFile);
    app.add_option("FOLDER", folder, "The batch's --out")->required()->check(CLI::ExistingDirectory);
    app.add_option("--assignment", assignment, "The batch's --assignment");
    CLI11_PARSE(app, argc, argv);
    try {
        return testat::check(download, folder, assignment) == 0 ? 0 : 1;
    } catch (std::exception const& e) {
        std::cerr << "check_feedback: " << e.what() << "\n";
        return 1;
    }
}
