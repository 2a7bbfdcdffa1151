// Every file of the corpus is graded as its first line says.
#include "corpus/uploads.h"
#include "sanitizers.h"

#include <set>

namespace testat {
namespace {
std::vector<Case> all_cases()
{
    std::vector<Case> cases = cases_in({"correct", "wrong"});
    for (auto const& compiler : compilers())
        cases.push_back({example_file(), compiler});
    return cases;
}

void expect_points(std::string const& name, Json const& function, Json const& loses)
{
    double const lost = function.at("max").get<double>() - function.at("earned").get<double>();
    Json const range = loses.value(name, Json::array({0, 0}));
    EXPECT_GE(lost, range.at(0).get<double>()) << name;
    EXPECT_LE(lost, range.at(1).get<double>()) << name;
}

void expect_word(std::string const& name, Json const& function, Json const& says)
{
    EXPECT_EQ(function.at("verdict"), says.value(name, "correct")) << name;
}

void expect_mistake(std::string const& name, Json const& function, Json const& mistakes)
{
    Json const named = function.contains("mistake") ? function.at("mistake").at("id") : Json();
    EXPECT_EQ(named, mistakes.value(name, Json())) << name;
}

/// What the policies leave of the points.
void expect_policy(Json const& report, Json const& policy)
{
    EXPECT_EQ(report.at("policy").at("applied"), policy);
    double const without = report.at("policy").at("earned_without");
    EXPECT_EQ(report.at("points").at("earned"), policy.empty() ? without : 0.0);
}

void expect_printing_is_noted(Json const& function)
{
    for (auto const& check : function.at("checks"))
        EXPECT_NE(check.at("hint").dump().find("prints"), std::string::npos) << check.at("name");
}

/// The grader and a reader of GRADING's table agree to half a point.
void expect_points_by_hand(Json const& report, Json const& verdict)
{
    if (!verdict.contains("by_hand"))
        return;
    double const graded = report.at("policy").at("earned_without");
    EXPECT_NEAR(graded, verdict.at("by_hand").get<double>(), 0.5);
}

void expect_remarks(Json const& report, Json const& remarks)
{
    Json found = Json::array();
    for (auto const& remark : report.value("remarks", Json::array()))
        found.push_back(remark.at("id"));
    EXPECT_EQ(found, remarks) << report.value("remarks", Json::array()).dump(2);
}

/// A verdict with a misspelt key would claim nothing.
void expect_known_names(Json const& verdict, Json const& report)
{
    std::set<std::string> const keys{"loses",   "says",    "policy",  "prints",
                                     "by_hand", "mistake", "remarks", "sanitizers"};
    for (auto const& [key, value] : verdict.items())
        EXPECT_TRUE(keys.count(key) > 0) << key;
    for (char const* key : {"loses", "says", "mistake"}) {
        Json const functions = verdict.value(key, Json::object());
        for (auto const& [name, value] : functions.items())
            EXPECT_TRUE(report.at("functions").contains(name)) << name;
    }
}

class Corpus : public testing::TestWithParam<Case> {};

TEST_P(Corpus, IsGradedAsItsFirstLineSays)
{
    Json const verdict = read_verdict(GetParam().file);
    if (is_sanitized && !verdict.value("sanitizers", true))
        GTEST_SKIP() << "the sanitizers bring a heap and signals of their own";
    TemporaryDirectory const place;
    Graded const graded = grade_file(GetParam().file, place.path(), {"--compiler", GetParam().compiler});
    ASSERT_EQ(graded.exit_code, 0) << graded.out << graded.err;
    ASSERT_EQ(graded.report.at("status"), "graded");
    EXPECT_TRUE(graded.report.at("build").at("ok").get<bool>());

    expect_known_names(verdict, graded.report);
    for (auto const& [name, function] : graded.report.at("functions").items()) {
        expect_points(name, function, verdict.at("loses"));
        expect_word(name, function, verdict.value("says", Json::object()));
        expect_mistake(name, function, verdict.value("mistake", Json::object()));
    }
    for (auto const& name : verdict.value("prints", Json::array()))
        expect_printing_is_noted(graded.report.at("functions").at(name.get<std::string>()));
    expect_points_by_hand(graded.report, verdict);
    expect_policy(graded.report, verdict.value("policy", Json::array()));
    expect_remarks(graded.report, verdict.value("remarks", Json::array()));
    if (HasFailure())
        std::cout << GetParam().file.string() << " with " << GetParam().compiler << "\n"
                  << function_table_of(graded.report);
}

INSTANTIATE_TEST_SUITE_P(Submissions, Corpus, testing::ValuesIn(all_cases()), name_of);
}  // namespace
}  // namespace testat
