#include "batch/table.h"

#include "batch/archive.h"
#include "batch/names.h"
#include "batch/times.h"
#include "text.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <pugixml.hpp>
#include <sstream>
#include <stdexcept>
#include <unordered_map>

namespace testat {
namespace {
constexpr std::size_t max_rows = 10'000;
constexpr std::size_t max_columns = 30;
constexpr std::size_t max_cell = 300;  // bytes
/// So many rows tell which columns hold the names.
constexpr std::size_t sample = 50;

std::string bytes_of(std::filesystem::path const& file)
{
    std::ifstream in(file, std::ios::binary);
    std::ostringstream bytes;
    bytes << in.rdbuf();
    return bytes.str();
}

pugi::xml_document parse(std::string const& xml, char const* what)
{
    pugi::xml_document document;
    auto const result =
        document.load_buffer(xml.data(), xml.size(), pugi::parse_default | pugi::parse_ws_pcdata_single);
    if (!result)
        throw std::invalid_argument(fmt::format("{} is damaged: {}", what, result.description()));
    return document;
}

/// Of a cell or shared string: rich text is several pieces, each in its <r>; readings (<rPh>) are left out.
std::string text_of(pugi::xml_node node)
{
    std::string text = node.child("t").text().get();
    for (pugi::xml_node run : node.children("r"))
        text += run.child("t").text().get();
    return text;
}

std::vector<std::string> shared_strings(std::string const& xml)
{
    std::vector<std::string> strings;
    if (xml.empty())
        return strings;
    auto const document = parse(xml, "sharedStrings.xml");
    for (pugi::xml_node string : document.child("sst").children("si"))
        strings.push_back(one_line(text_of(string), max_cell));
    return strings;
}

std::string cell_text(pugi::xml_node cell, std::vector<std::string> const& strings)
{
    std::string const type = cell.attribute("t").value();
    if (type == "inlineStr")
        return one_line(text_of(cell.child("is")), max_cell);
    if (type != "s")
        return one_line(cell.child("v").text().get(), max_cell);
    std::size_t const index = cell.child("v").text().as_uint(~0u);
    return index < strings.size() ? strings[index] : "";
}

/// 2 of "C5"; `next` if it does not say.
std::size_t column_of(pugi::xml_node cell, std::size_t next)
{
    std::size_t column = 0;
    for (char const* c = cell.attribute("r").value(); *c >= 'A' && *c <= 'Z' && column < 1000; ++c)
        column = column * 26 + std::size_t(*c - 'A' + 1);
    return column == 0 ? next : column - 1;
}

std::vector<std::string> read_row(pugi::xml_node row, std::vector<std::string> const& strings)
{
    std::vector<std::string> cells;
    for (pugi::xml_node cell : row.children("c")) {
        std::size_t const column = column_of(cell, cells.size());
        if (column >= max_columns)
            continue;
        cells.resize(std::max(cells.size(), column + 1));
        cells[column] = cell_text(cell, strings);
    }
    return cells;
}

/// Finds the columns, then whose row is whose.
class Join {
public:
    Join(Rows const& rows, std::vector<std::string> const& persons) : rows_(rows), persons_(persons)
    {
        for (std::size_t i = 0; i < persons.size(); ++i)
            for (std::size_t at = persons[i].find('_'); at != std::string::npos; at = persons[i].find('_', at + 1))
                endings_[lower_case(persons[i].substr(at + 1))].push_back(i);
        login_ = best_column([this](std::string const& cell, std::size_t) { return !with_login(cell).empty(); });
        find_names();
        time_ = best_column([this](std::string const& cell, std::size_t column) {
            return column != login_ && parse_cell_time(cell).has_value();
        });
    }

    Joined result() const
    {
        Joined joined;
        joined.submitters.resize(persons_.size());
        for (std::size_t row = 0; row < rows_.size(); ++row) {
            Submitter const submitter = read(rows_[row], last_, first_);
            auto const found = persons_of(submitter);
            for (std::size_t person : found)
                prefer(joined.submitters[person], submitter);
            if (found.empty() && row > 0 && !submitter.login.empty())
                joined.without_folder.push_back(submitter);
        }
        if (std::none_of(joined.submitters.begin(), joined.submitters.end(), [](auto const& s) { return s; }))
            joined.without_folder.clear();
        return joined;
    }

private:
    static std::string const& cell(std::vector<std::string> const& row, std::size_t column)
    {
        static std::string const none;
        return column < row.size() ? row[column] : none;
    }

    std::vector<std::size_t> with_login(std::string const& login) const
    {
        auto const found = login.empty() ? endings_.end() : endings_.find(lower_case(login));
        return found == endings_.end() ? std::vector<std::size_t>{} : found->second;
    }

    template <class Fits>
    std::size_t best_column(Fits const& fits) const
    {
        std::vector<std::size_t> counts(max_columns);
        for (auto const& row : rows_)
            for (std::size_t i = 0; i < row.size(); ++i)
                counts[i] += fits(row[i], i) ? 2 : 0;
        // Of several times it is the one of handing in; its heading is known in two languages.
        for (std::size_t i = 0; i < counts.size() && !rows_.empty(); ++i) {
            std::string const heading = lower_case(cell(rows_[0], i));
            bool const is_submission = heading.find("submi") == 0 || heading.find("abgabe") != std::string::npos;
            counts[i] += counts[i] > 0 && is_submission ? 1 : 0;
        }
        return std::size_t(std::max_element(counts.begin(), counts.end()) - counts.begin());
    }

    /// The pair of columns with which most rows find a folder; one column may hold "Lastname, Firstname".
    void find_names()
    {
        Rows some;
        for (auto const& row : rows_)
            if (some.size() < sample && !with_login(cell(row, login_)).empty())
                some.push_back(row);
        std::size_t best = 0;
        for (std::size_t last = 0; last < max_columns; ++last)
            for (std::size_t first = 0; first < max_columns; ++first) {
                std::size_t const fitting = std::size_t(std::count_if(some.begin(), some.end(), [&](auto const& row) {
                    return !persons_of(read(row, last, first)).empty();
                }));
                if (fitting <= best)
                    continue;
                best = fitting;
                last_ = last;
                first_ = first;
            }
    }

    Submitter read(std::vector<std::string> const& row, std::size_t last, std::size_t first) const
    {
        Submitter submitter{cell(row, last), cell(row, first), cell(row, login_), parse_cell_time(cell(row, time_))};
        std::size_t const comma = submitter.lastname.find(", ");
        if (last == first && comma != std::string::npos) {
            submitter.firstname = submitter.lastname.substr(comma + 2);
            submitter.lastname.resize(comma);
        }
        return submitter;
    }

    std::vector<std::size_t> persons_of(Submitter const& submitter) const
    {
        std::vector<std::size_t> found;
        if (submitter.lastname.empty() && submitter.firstname.empty())
            return found;
        for (std::size_t person : with_login(submitter.login))
            if (may_be(persons_[person], submitter.lastname, submitter.firstname, submitter.login))
                found.push_back(person);
        return found;
    }

    /// "b_c" fits "..._b_c" better than "c" does.
    static void prefer(std::optional<Submitter>& known, Submitter const& other)
    {
        auto const rank = [](Submitter const& s) { return std::pair(s.login.size(), s.submitted); };
        if (!known || rank(*known) < rank(other))
            known = other;
    }

    Rows const& rows_;
    std::vector<std::string> const& persons_;
    std::unordered_map<std::string, std::vector<std::size_t>> endings_;  ///< what may be a login, to persons
    std::size_t login_ = 0;
    std::size_t last_ = max_columns;  ///< not found
    std::size_t first_ = max_columns;
    std::size_t time_ = max_columns;
};
}  // namespace

Rows read_sheet(std::string const& sheet, std::string const& strings)
{
    auto const shared = shared_strings(strings);
    auto const document = parse(sheet, "its first sheet");
    Rows rows;
    for (pugi::xml_node row : document.child("worksheet").child("sheetData").children("row"))
        if (rows.size() < max_rows)
            rows.push_back(read_row(row, shared));
    return rows;
}

Rows read_xlsx(std::filesystem::path const& xlsx, std::filesystem::path const& scratch)
{
    std::map<std::string, std::filesystem::path> parts;
    for (auto const& entry : unpack(xlsx, scratch).entries)
        if (!entry.file.empty())
            parts.emplace(entry.name, entry.file);
    std::string const first = "xl/worksheets/sheet";
    auto const sheet = parts.lower_bound(first);
    if (sheet == parts.end() || sheet->first.rfind(first, 0) != 0)
        throw std::invalid_argument("it has no sheet");
    auto const strings = parts.find("xl/sharedStrings.xml");
    return read_sheet(bytes_of(sheet->second), strings == parts.end() ? "" : bytes_of(strings->second));
}

Joined join(Rows const& rows, std::vector<std::string> const& persons)
{
    return Join(rows, persons).result();
}
}  // namespace testat
