#include "batch/overrides.h"

#include "example_grading.h"
#include "installation.h"
#include "json_schema.h"
#include "process/run.h"

#include <gtest/gtest.h>

namespace testat {
namespace {
Report example_report(bool built = true)
{
    Rubric const rubric = example_rubric();
    CheckResults const results = passed_results(rubric);
    Build const build = built ? whole_build() : mended_build();
    return make_report({}, build, results, score(results, build, rubric, false), rubric, {"1", "", 1}, {}, {});
}

Override const half{"anna", "wrap_clamp", 0.5, "late but explained", "Tutor", "2026-11-24"};
Override const total{"anna", "total", 1.25, "talked it over", "Tutor", "2026-11-24"};

std::vector<Override> read(std::string const& text)
{
    TemporaryDirectory const place;
    write_file(place.path() / "overrides.json", text);
    return read_overrides(place.path() / "overrides.json");
}
}  // namespace

TEST(Overrides, ChangeFunctionTaskAndSum)
{
    Report const before = example_report();
    Report const after = apply({half}, {"anna"}, before);
    EXPECT_EQ(after.at("functions").at("wrap_clamp").at("earned"), 0.5);
    EXPECT_EQ(after.at("functions").at("wrap_clamp").at("override").at("points_before"), 1.0);
    EXPECT_EQ(after.at("tasks").at(0).at("earned").get<double>(),
              before.at("tasks").at(0).at("earned").get<double>() - 0.5);
    EXPECT_EQ(after.at("points").at("earned"), 1.5);
    EXPECT_EQ(after.at("policy").at("earned_without"), 1.5);
}

TEST(Overrides, KeepTheReportsSchema)
{
    Report const after = apply({half, total}, {"anna"}, example_report());
    auto const schema = installation().rubric.parent_path() / "report.schema.json";
    EXPECT_NO_THROW(validate_json(nlohmann::json::parse(to_text(after)), schema, "report"));
}

TEST(Overrides, LeaveOthersAlone)
{
    EXPECT_EQ(apply({half}, {"bert"}, example_report()), example_report());
    EXPECT_EQ(apply({half}, {"bert", "anna"}, example_report()), apply({half}, {"anna"}, example_report()));
}

TEST(Overrides, OfAFunctionStayWithinTheSheetsRules)
{
    Report const after = apply({half}, {"anna"}, example_report(false));
    EXPECT_EQ(after.at("points").at("earned"), 0.0);
}

TEST(Overrides, OfTheTotalHaveTheLastWord)
{
    Report const after = apply({total, half}, {"anna"}, example_report(false));
    EXPECT_EQ(after.at("points").at("earned"), 1.25);
    EXPECT_TRUE(after.at("points").at("passed_60_percent"));
    EXPECT_EQ(after.at("points").at("override").at("who"), "Tutor");
}

TEST(Overrides, CannotGiveMoreThanThereIs)
{
    Override much = half;
    much.points = 1.5;
    EXPECT_THROW(apply({much}, {"anna"}, example_report()), std::invalid_argument);
    Override unknown = half;
    unknown.function = "wrap_around";
    EXPECT_THROW(apply({unknown}, {"anna"}, example_report()), std::invalid_argument);
}

TEST(Overrides, AreReadFromAList)
{
    auto const all = read(R"([{"student": "anna", "function": "total", "points": 3, "reason": "r", "who": "w",
                               "when": "2026-11-24"}])");
    ASSERT_EQ(all.size(), 1u);
    EXPECT_EQ(all[0].function, "total");
    EXPECT_EQ(all[0].points, 3);
}

TEST(Overrides, SayWhichEntryIsWrong)
{
    for (char const* text :
         {"{}", "[1]", R"([{"student": "a"}])",
          R"([{"student": "a", "function": "total", "points": -1, "reason": "r", "who": "w", "when": "x"}])",
          R"([{"student": "a", "function": "total", "points": 1, "reason": "", "who": "w", "when": "x"}])"})
        EXPECT_THROW(read(text), BadJson) << text;
}

TEST(Overrides, AreNoneWithoutAFile)
{
    EXPECT_TRUE(read_overrides("/no/such/overrides.json").empty());
}
}  // namespace testat
