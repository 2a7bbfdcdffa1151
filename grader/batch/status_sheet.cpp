#include "batch/ilias.h"

#include <fmt/format.h>
#include <xlsxwriter.h>

#include <ctime>
#include <stdexcept>

namespace testat {
namespace {
using Row = std::vector<std::string>;

Row const student_columns{"update", "usr_id", "login",   "lastname",   "firstname",   "status",
                          "mark",   "notice", "comment", "plagiarism", "plag_comment"};
Row const team_columns{"update", "team_id", "logins",     "status",      "mark",
                       "notice", "comment", "plagiarism", "plag_comment"};

std::string mark(Report const& report)
{
    return report.at("status") == "graded" ? fmt::format("{:.2f}", report.at("points").at("earned").get<double>()) : "";
}

/// For the learner.
std::string comment(Report const& report, Language language)
{
    if (report.at("status") != "graded")
        return "";
    auto const& points = report.at("points");
    return fmt::format(fmt::runtime(language == Language::de ? "{:.2f} von {:.2f} Punkten" : "{:.2f} of {:.2f} points"),
                       points.at("earned").get<double>(), points.at("max").get<double>());
}

/// For tutors.
std::string notice(GradedUpload const& entry)
{
    std::string text = entry.upload.late ? "late" : "";
    if (!entry.is_graded())
        text += (text.empty() ? "" : "; ") + entry.report.at("error").get<std::string>();
    return text;
}

std::string all_logins(Upload const& upload)
{
    return upload.logins.empty() ? upload.login : fmt::format("{}", fmt::join(upload.logins, ", "));
}

Row row_of(GradedUpload const& entry, bool of_teams, Language language)
{
    auto const& upload = entry.upload;
    Row row{entry.is_graded() ? "1" : "0"};
    Row const who = of_teams ? Row{upload.team, all_logins(upload)}
                             : Row{upload.usr_id, upload.login, upload.lastname, upload.firstname};
    row.insert(row.end(), who.begin(), who.end());
    Row const what{
        ilias_status(entry.report), mark(entry.report), notice(entry), comment(entry.report, language), "", ""};
    row.insert(row.end(), what.begin(), what.end());
    return row;
}

/// Texts stay texts: a spreadsheet computes nothing of them.
void write_row(lxw_worksheet* sheet, lxw_row_t row, Row const& cells)
{
    for (std::size_t column = 0; column < cells.size(); ++column)
        worksheet_write_string(sheet, row, static_cast<lxw_col_t>(column), cells[column].c_str(), nullptr);
}
}  // namespace

std::string ilias_status(Report const& report)
{
    if (report.at("status") != "graded")
        return "notgraded";
    return report.at("points").at("passed_60_percent").get<bool>() ? "passed" : "failed";
}

void write_status_sheet(std::vector<GradedUpload> const& entries, bool of_teams, Language language,
                        std::filesystem::path const& file)
{
    lxw_workbook* const book = workbook_new(file.c_str());
    if (book == nullptr)
        throw std::runtime_error("cannot write " + file.string());
    lxw_doc_properties properties = {};
    properties.created = 1;  // the same bytes each time
    workbook_set_properties(book, &properties);
    lxw_worksheet* const sheet = workbook_add_worksheet(book, nullptr);
    write_row(sheet, 0, of_teams ? team_columns : student_columns);
    lxw_row_t row = 1;
    for (auto const& entry : entries)
        if (entry.upload.team.empty() != of_teams)
            write_row(sheet, row++, row_of(entry, of_teams, language));
    if (workbook_close(book) != LXW_NO_ERROR)
        throw std::runtime_error("cannot write " + file.string());
}
}  // namespace testat
