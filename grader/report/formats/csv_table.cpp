#include "report/formats/csv_table.h"

namespace testat {
namespace {
std::string quoted(std::string const& text)
{
    if (text.find_first_of(",\"\r\n") == std::string::npos)
        return text;
    std::string out = "\"";
    for (char c : text)
        out += c == '"' ? "\"\"" : std::string(1, c);
    return out + "\"";
}

std::string joined(std::vector<std::string> const& cells)
{
    std::string line;
    for (auto const& cell : cells)
        line += (&cell == &cells.front() ? "" : ",") + quoted(cell);
    return line + "\r\n";
}
}  // namespace

void CsvTable::add(std::string const& column, std::size_t row, std::string const& cell)
{
    if (cells_.count(column) == 0)
        columns_.push_back(column);
    cells_[column][row] = cell;
}

void CsvTable::add_text(std::string const& column, std::size_t row, std::string const& text)
{
    add(column, row, text.find_first_of("=+-@\t\r") == 0 ? "'" + text : text);
}

std::string CsvTable::print(std::size_t rows) const
{
    std::string out = joined(columns_);
    for (std::size_t row = 0; row < rows; ++row) {
        std::vector<std::string> cells;
        for (auto const& column : columns_)
            cells.push_back(cell(column, row));
        out += joined(cells);
    }
    return out;
}

std::string CsvTable::cell(std::string const& column, std::size_t row) const
{
    auto const& cells = cells_.at(column);
    auto const found = cells.find(row);
    return found == cells.end() ? "" : found->second;
}
}  // namespace testat
