#include "batch/batch.h"
#include "report/formats/csv_table.h"
#include "report/reading.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

namespace testat {
namespace {
std::string date(std::optional<std::int64_t> const& seconds)
{
    return seconds ? fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time_t(*seconds))) : "";
}

std::string overrides_in(Report const& report)
{
    return report.at("status") == "graded" ? fmt::format("{}", fmt::join(Reading(report).by_hand(), "; ")) : "";
}
}  // namespace

std::string grades_table(std::vector<GradedUpload> const& entries)
{
    CsvTable table;
    for (std::size_t row = 0; row < entries.size(); ++row) {
        auto const& upload = entries[row].upload;
        for (auto const& [column, text] : {std::pair("name", upload.student), std::pair("lastname", upload.lastname),
                                           std::pair("firstname", upload.firstname), std::pair("login", upload.login),
                                           std::pair("usr_id", upload.usr_id), std::pair("team", upload.team)})
            table.add_text(column, row, text);
        table.add("submitted", row, date(upload.submitted));
        table.add("late", row, upload.late ? "1" : "0");
        table.add_text("overrides", row, overrides_in(entries[row].report));
        add_report(table, row, entries[row].report);
    }
    return table.print(entries.size());
}
}  // namespace testat
