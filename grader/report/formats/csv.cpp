#include "report/formats/csv_table.h"
#include "report/formats/format.h"

#include <fmt/format.h>

namespace testat {
namespace {
std::string number(Report const& value)
{
    return value.is_number() ? fmt::format("{}", value.get<double>()) : "";
}

std::string joined(Report const& list)
{
    std::string all;
    for (auto const& entry : list)
        all += (all.empty() ? "" : " ") + entry.get<std::string>();
    return all;
}

void add_graded(CsvTable& table, std::size_t row, Report const& report)
{
    auto const& points = report.at("points");
    table.add("earned", row, number(points.at("earned")));
    table.add("max", row, number(points.at("max")));
    table.add("passed_60_percent", row, points.at("passed_60_percent").get<bool>() ? "1" : "0");
    table.add("earned_without_policy", row, number(report.at("policy").at("earned_without")));
    table.add("policy", row, joined(report.at("policy").at("applied")));
    for (auto const& [name, function] : report.at("functions").items())
        table.add(name, row, number(function.at("earned")));
    for (auto const& [name, function] : report.at("functions").items()) {
        table.add(name + ".mistake", row,
                  function.contains("mistake") ? function.at("mistake").at("id").get<std::string>() : "");
        for (auto const& check : function.at("checks"))
            table.add(check.at("name"), row, check.at("passed").get<bool>() ? "1" : "0");
    }
}
}  // namespace

void add_report(CsvTable& table, std::size_t row, Report const& report)
{
    table.add_text("file", row, report.at("submission").at("file"));
    table.add("sha256", row, report.at("submission").at("sha256"));
    table.add("status", row, report.at("status"));
    if (report.at("status") == "graded")
        add_graded(table, row, report);
}

std::string to_csv(std::vector<NamedReport> const& reports, Language /*language*/)
{
    CsvTable table;
    for (std::size_t row = 0; row < reports.size(); ++row) {
        table.add_text("name", row, reports[row].name);
        add_report(table, row, reports[row].report);
    }
    return table.print(reports.size());
}
}  // namespace testat
