#include "report/formats/format.h"

#include <fmt/format.h>

#include <map>

namespace testat {
namespace {
/// A column's heading, and its cell in each report that has one.
class Table {
public:
    void add(std::string const& column, std::size_t row, std::string const& cell)
    {
        if (cells_.count(column) == 0)
            columns_.push_back(column);
        cells_[column][row] = cell;
    }
    std::string print(std::size_t rows) const
    {
        std::string out;
        for (auto const& column : columns_)
            out += (out.empty() ? "" : ",") + quoted(column);
        out += "\r\n";
        for (std::size_t row = 0; row < rows; ++row) {
            for (auto const& column : columns_)
                out += (&column == &columns_.front() ? "" : ",") + cell(column, row);
            out += "\r\n";
        }
        return out;
    }

private:
    std::string cell(std::string const& column, std::size_t row) const
    {
        auto const& cells = cells_.at(column);
        auto const found = cells.find(row);
        return found == cells.end() ? "" : quoted(found->second);
    }
    static std::string quoted(std::string const& text)
    {
        if (text.find_first_of(",\"\r\n") == std::string::npos)
            return text;
        std::string out = "\"";
        for (char c : text)
            out += c == '"' ? "\"\"" : std::string(1, c);
        return out + "\"";
    }

    std::vector<std::string> columns_;
    std::map<std::string, std::map<std::size_t, std::string>> cells_;
};

/// What a spreadsheet would compute becomes a text.
std::string harmless(std::string const& text)
{
    return text.find_first_of("=+-@\t\r") == 0 ? "'" + text : text;
}

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

void add_graded(Table& table, std::size_t row, Report const& report)
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

std::string to_csv(std::vector<NamedReport> const& reports, Language /*language*/)
{
    Table table;
    for (std::size_t row = 0; row < reports.size(); ++row) {
        auto const& [name, report] = reports[row];
        table.add("name", row, harmless(name));
        table.add("file", row, harmless(report.at("submission").at("file")));
        table.add("sha256", row, report.at("submission").at("sha256"));
        table.add("status", row, report.at("status"));
        if (report.at("status") == "graded")
            add_graded(table, row, report);
    }
    return table.print(reports.size());
}
}  // namespace testat
