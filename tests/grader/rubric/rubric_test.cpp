#include "rubric/rubric.h"

#include "installation.h"
#include "json_schema.h"
#include "process/run.h"
#include "report/report.h"

#include <gtest/gtest.h>

#include <functional>
#include <numeric>

namespace testat {
namespace {
using Json = nlohmann::json;

Rubric const& shipped()
{
    static Rubric const rubric = read_rubric(installation().rubric);
    return rubric;
}

double points_of(Rubric const& rubric)
{
    return std::accumulate(rubric.functions.begin(), rubric.functions.end(), 0.0,
                           [](double sum, RubricFunction const& f) { return sum + f.points; });
}

double weight_of(RubricFunction const& function)
{
    return std::accumulate(function.checks.begin(), function.checks.end(), 0.0,
                           [](double sum, RubricCheck const& c) { return sum + c.weight; });
}

/// What reading the shipped rubric says after this change; empty if it is accepted.
std::string complaint_after(std::function<void(Json&)> const& change)
{
    TemporaryDirectory const directory;
    Json json = read_json(installation().rubric);
    change(json);
    auto schema = installation().rubric;
    std::filesystem::copy_file(schema.replace_extension(".schema.json"), directory.path() / "rubric.schema.json");
    write_file(directory.path() / "rubric.json", json.dump());
    try {
        read_rubric(directory.path() / "rubric.json");
    } catch (BadJson const& e) {
        return e.what();
    } catch (BadRubric const& e) {
        return e.what();
    }
    return "";
}

testing::AssertionResult names(std::string const& complaint, std::string const& place)
{
    if (complaint.find(place) != std::string::npos)
        return testing::AssertionSuccess();
    return testing::AssertionFailure() << "'" << complaint << "' does not name " << place;
}
}  // namespace

TEST(ShippedRubric, HasTwentyPoints)
{
    EXPECT_EQ(points_of(shipped()), 20);
    EXPECT_EQ(shipped().pass_fraction, 0.6);
}

TEST(ShippedRubric, HasTheSheetsTasks)
{
    std::map<char, double> points;
    for (auto const& function : shipped().functions)
        points[function.task] += function.points;
    EXPECT_EQ(points, (std::map<char, double>{{'a', 2}, {'b', 2}, {'c', 4}, {'d', 6}, {'e', 4}, {'f', 2}}));
    EXPECT_EQ(shipped().tasks.size(), 6u);
}

TEST(ShippedRubric, PutsFunctionsInTheSheetsOrderUnderTheirTask)
{
    ASSERT_EQ(shipped().functions.size(), function_count);
    for (std::uint32_t i = 0; i < function_count; ++i) {
        EXPECT_EQ(shipped().functions[i].function, static_cast<Function>(i));
        EXPECT_EQ(shipped().functions[i].task, function_table[i].task) << function_table[i].name;
    }
}

TEST(ShippedRubric, HasAPublicEssentialCheckForEveryFunction)
{
    for (auto const& function : shipped().functions)
        EXPECT_TRUE(std::any_of(function.checks.begin(), function.checks.end(), [](auto const& c) {
            return c.essential && c.is_public;
        })) << info(function.function).name;
}

TEST(ShippedRubric, HasPoliciesForCompilingAndCrashing)
{
    ASSERT_EQ(shipped().policies.size(), 2u);
    EXPECT_EQ(shipped().policies[0].id, "does_not_compile");
    EXPECT_EQ(shipped().policies[1].id, "crashes");
    EXPECT_EQ(shipped().policies[1].ends.count("signal"), 1u);
    EXPECT_EQ(shipped().policies[1].ends.count("timed_out"), 0u);
}

TEST(ReadRubric, AcceptsTheShippedOne)
{
    EXPECT_EQ(complaint_after([](Json&) {}), "");
}

TEST(ReadRubric, RefusesUnknownKeys)
{
    EXPECT_TRUE(names(complaint_after([](Json& j) { j["extra"] = 1; }), "extra"));
    EXPECT_TRUE(names(complaint_after([](Json& j) { j["functions"]["intersect"]["bonus"] = 1; }), "[intersect]"));
}

TEST(ReadRubric, RefusesWeightsThatDoNotAddUp)
{
    EXPECT_TRUE(names(complaint_after([](Json& j) { j["functions"]["wrap_clamp"]["checks"][0]["weight"] = 0.3; }),
                      "the weights of wrap_clamp add up to 1.1"));
}

TEST(ReadRubric, RefusesWeightsOutsideZeroToOne)
{
    EXPECT_TRUE(names(complaint_after([](Json& j) { j["functions"]["wrap_clamp"]["checks"][0]["weight"] = -1; }),
                      "[wrap_clamp]"));
}

TEST(ReadRubric, RefusesAFunctionWithoutEssentialCheck)
{
    auto const make_all_optional = [](Json& j) {
        for (auto& check : j["functions"]["intersect"]["checks"])
            check.erase("essential");
    };
    EXPECT_TRUE(names(complaint_after(make_all_optional), "intersect has no essential check"));
}

TEST(ReadRubric, RefusesUnknownAndMissingFunctions)
{
    EXPECT_TRUE(names(complaint_after([](Json& j) { j["functions"]["evaluate"] = j["functions"]["intersect"]; }),
                      "'evaluate' is no function of the sheet"));
    EXPECT_TRUE(names(complaint_after([](Json& j) { j["functions"].erase("intersect"); }), "10 functions"));
}

TEST(ReadRubric, RefusesAMissingLanguage)
{
    EXPECT_TRUE(names(complaint_after([](Json& j) { j["tasks"][2]["title"].erase("de"); }), "[tasks][2][title]"));
    EXPECT_TRUE(names(complaint_after([](Json& j) { j["functions"]["intersect"]["checks"][1]["hint"]["en"] = ""; }),
                      "[intersect][checks][1][hint][en]"));
}

TEST(ReadRubric, RefusesWrongTypes)
{
    EXPECT_TRUE(names(complaint_after([](Json& j) { j["functions"]["intersect"]["points"] = "2"; }), "[points]"));
    EXPECT_TRUE(names(complaint_after([](Json& j) { j["rounding"] = 0; }), "[rounding]"));
    EXPECT_TRUE(names(complaint_after([](Json& j) { j["policies"][1]["ends"] = {"answered"}; }), "[policies][1]"));
}

TEST(ReadRubric, NamesAFileThatIsNotThereOrNoJson)
{
    TemporaryDirectory const directory;
    EXPECT_THROW(read_rubric(directory.path() / "rubric.json"), BadJson);
    write_file(directory.path() / "rubric.json", "{");
    EXPECT_THROW(read_rubric(directory.path() / "rubric.json"), BadJson);
}

TEST(OnlyTasks, LeavesTheOthersOut)
{
    Rubric const rubric = only_tasks(shipped(), {'a', 'e'});
    EXPECT_EQ(points_of(rubric), 6);
    ASSERT_EQ(rubric.tasks.size(), 2u);
    EXPECT_EQ(rubric.tasks[1].id, 'e');
}

TEST(OnlyTasks, RefusesLettersThatAreNoTask)
{
    EXPECT_THROW(only_tasks(shipped(), {'a', 'g'}), std::invalid_argument);
}

TEST(OnlyPublic, LeavesHiddenChecksOut)
{
    for (auto const& function : only_public(shipped()).functions)
        for (auto const& check : function.checks)
            EXPECT_TRUE(check.is_public) << check.name;
}

TEST(OnlyPublic, MakesWeightsAddUpToOneAgain)
{
    for (auto const& function : only_public(shipped()).functions)
        EXPECT_NEAR(weight_of(function), 1, 1e-12) << info(function.function).name;
    EXPECT_EQ(points_of(only_public(shipped())), 20);
}

TEST(OnlyPublic, SharesEquallyWhereNothingWeighed)
{
    Rubric rubric = shipped();
    for (auto& check : rubric.functions[0].checks)
        check.weight = check.is_public ? 0 : 1;
    Rubric const shown = only_public(rubric);
    for (auto const& check : shown.functions[0].checks)
        EXPECT_NEAR(check.weight, 1.0 / double(shown.functions[0].checks.size()), 1e-12);
}

TEST(NameOf, KnowsEveryEnd)
{
    EXPECT_EQ(name_of(Ended::answered), "answered");
    EXPECT_EQ(name_of(Ended::timed_out), "timed_out");
    EXPECT_EQ(name_of(Ended::lost), "lost");
}
}  // namespace testat
