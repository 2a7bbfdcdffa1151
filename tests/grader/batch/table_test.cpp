#include "batch/table.h"

#include "batch/times.h"
#include "batch/zips.h"
#include "process/run.h"
#include "report/report.h"

#include <gtest/gtest.h>

namespace testat {
namespace {
Rows const german = {{"Nachname", "Vorname", "Anmeldename", "Abgabedatum", "Note"},
                     {"Müller", "Jörg", "umuel", "46350.5", "1.3"},
                     {"王", "爽", "uwang", "46351.5", ""},
                     {"O'Neil", "Anne-Marie", "u_neil", "46352.5", ""}};
std::vector<std::string> const persons = {"___________uwang", "Mueller_Joerg_umuel", "O_Neil_Anne-Marie_u_neil"};

void expect_joined(Rows const& rows)
{
    auto const submitters = join(rows, persons).submitters;
    ASSERT_EQ(submitters.size(), 3u);
    for (auto const& submitter : submitters)
        ASSERT_TRUE(submitter);
    EXPECT_EQ(submitters[0]->lastname, "王");
    EXPECT_EQ(submitters[1]->lastname, "Müller");
    EXPECT_EQ(submitters[1]->firstname, "Jörg");
    EXPECT_EQ(submitters[1]->login, "umuel");
    EXPECT_EQ(submitters[1]->submitted, parse_iso_time("2026-11-24T12:00"));
    EXPECT_EQ(submitters[2]->login, "u_neil");
}

std::string cells(std::string const& xml)
{
    return "<worksheet><sheetData><row>" + xml + "</row></sheetData></worksheet>";
}
}  // namespace

TEST(Join, FindsWhoseRowIsWhose)
{
    expect_joined(german);
}

TEST(Join, DependsNeitherOnTheOrderOfColumnsNorOnHeadings)
{
    Rows rows;
    for (auto const& row : german)
        rows.push_back({row[3], "", row[2], row[1], row[0], "x"});
    rows[0] = {"a", "b", "c", "d", "e", "f"};
    expect_joined(rows);
}

TEST(Join, TakesNamesInOneColumn)
{
    Rows rows;
    for (auto const& row : german)
        rows.push_back({row[0] + ", " + row[1], row[2], row[3]});
    expect_joined(rows);
}

TEST(Join, TakesTheLatestOfSeveralRows)
{
    Rows rows = german;
    rows.insert(rows.begin() + 1, {"Müller", "Jörg", "umuel", "46349.5"});
    rows.push_back({"Müller", "Jörg", "umuel", ""});
    expect_joined(rows);
}

TEST(Join, TakesTheTimeOfSubmission)
{
    Rows rows;
    for (auto const& row : german)
        rows.push_back({"46400.5", row[0], row[1], row[2], row[3]});
    rows[0] = {"Last access", "Last name", "First name", "Login", "Submission"};
    expect_joined(rows);
}

TEST(Join, NamesWhoHasNoFolder)
{
    Rows rows = german;
    rows.push_back({"Schulz", "Eva", "uschu", "46350.5"});
    auto const without = join(rows, persons).without_folder;
    ASSERT_EQ(without.size(), 1u);
    EXPECT_EQ(without[0].lastname, "Schulz");
}

TEST(Join, PrefersTheLongerLogin)
{
    Rows const rows = {{"Last", "First", "Login"}, {"A", "B é", "c"}, {"A", "B", "x_c"}, {"D", "E", "f"}};
    auto const joined = join(rows, {"A_B_x_c", "D_E_f"});
    ASSERT_TRUE(joined.submitters[0]);
    EXPECT_EQ(joined.submitters[0]->login, "x_c");
}

TEST(Join, LeavesStrangersOut)
{
    auto const joined = join(german, {"Maier_Joerg_umuel", "Foo_Bar_ufoo"});
    EXPECT_FALSE(joined.submitters[0]);
    EXPECT_FALSE(joined.submitters[1]);
    EXPECT_TRUE(joined.without_folder.empty());
    EXPECT_FALSE(join({}, persons).submitters[0]);
    EXPECT_TRUE(join(german, {}).without_folder.empty());
}

TEST(Sheet, HasCellsOfAllKinds)
{
    std::string const strings =
        "<sst><si><t>plain</t></si><si><r><t>rich</t></r><r><t xml:space='preserve'> text</t></r></si></sst>";
    Rows const rows = read_sheet(cells("<c t='s'><v>0</v></c><c r='C1' t='s'><v>1</v></c><c><v>46350.5</v></c>"
                                       "<c t='inlineStr'><is><t>in line</t></is></c><c t='str'><v>f</v></c>"
                                       "<c t='s'><v>7</v></c><c/>"),
                                 strings);
    ASSERT_EQ(rows.size(), 1u);
    EXPECT_EQ(rows[0], (std::vector<std::string>{"plain", "", "rich text", "46350.5", "in line", "f", "", ""}));
}

TEST(Sheet, IsNotBelieved)
{
    EXPECT_EQ(read_sheet(cells("<c r='ZZZZZZZZZZZZZ1'><v>1</v></c>"), "").at(0).size(), 0u);
    EXPECT_LE(read_sheet(cells("<c><v>" + std::string(10'000, 'a') + "</v></c>"), "").at(0).at(0).size(), 303u);
    EXPECT_TRUE(read_sheet("<html/>", "").empty());
    EXPECT_THROW(read_sheet("<worksheet>", ""), std::invalid_argument);
    EXPECT_THROW(read_sheet("", ""), std::invalid_argument);
}

TEST(Xlsx, IsRead)
{
    TemporaryDirectory const root;
    write_xlsx(root.path() / "a.xlsx", german);
    EXPECT_EQ(read_xlsx(root.path() / "a.xlsx", root.path() / "scratch"), german);
}

TEST(Xlsx, WithoutASheetIsDamaged)
{
    TemporaryDirectory const root;
    write_file(root.path() / "a.xlsx", raw_zip({{"xl/other.xml"}}));
    EXPECT_THROW(read_xlsx(root.path() / "a.xlsx", root.path() / "scratch"), std::invalid_argument);
}
}  // namespace testat
