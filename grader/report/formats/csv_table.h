#pragma once
#include "report/report.h"

#include <map>
#include <string>
#include <vector>

namespace testat {
/// A table as RFC 4180 wants it. Columns come in the order in which they are first named; a row need not have all.
class CsvTable {
public:
    void add(std::string const& column, std::size_t row, std::string const& cell);

    /// A text from outside: what a spreadsheet would compute gets an apostrophe in front.
    void add_text(std::string const& column, std::size_t row, std::string const& text);

    /// The header, then rows 0 to rows - 1; lines end with CR LF.
    std::string print(std::size_t rows) const;

private:
    std::string cell(std::string const& column, std::size_t row) const;

    std::vector<std::string> columns_;
    std::map<std::string, std::map<std::size_t, std::string>> cells_;
};

/// The columns of to_csv, but for the name.
void add_report(CsvTable& table, std::size_t row, Report const& report);
}  // namespace testat
