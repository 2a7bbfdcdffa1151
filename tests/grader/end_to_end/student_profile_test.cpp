// `testat grade --profile student`: what a student may see.
#include "end_to_end/testat_program.h"

#include <gtest/gtest.h>

namespace testat {
namespace {
/// A mistake in every task, most of them found by hidden checks.
Graded grade_example(std::string const& profile)
{
    TemporaryDirectory const place;
    return grade_file(example_file(), place.path(), {"--profile", profile});
}

std::vector<std::string> hidden_checks()
{
    std::vector<std::string> names;
    Json const report = grade_example("tutor").report;
    for (auto const& [name, function] : report.at("functions").items())
        for (auto const& check : function.at("checks"))
            if (check.at("visibility") == "hidden")
                names.push_back(check.at("name"));
    return names;
}

TEST(StudentProfile, ShowsNoHiddenCheck)
{
    Graded const graded = grade_example("student");
    std::string const everything = graded.report.dump() + graded.out;
    auto const hidden = hidden_checks();
    EXPECT_GE(hidden.size(), 11u);
    for (auto const& name : hidden)
        EXPECT_EQ(everything.find(name), std::string::npos) << name;
    EXPECT_EQ(everything.find("\"hidden\""), std::string::npos);
}

TEST(StudentProfile, ShowsNoDetail)
{
    Graded const graded = grade_example("student");
    for (auto const& [name, function] : graded.report.at("functions").items())
        for (auto const& check : function.at("checks"))
            EXPECT_TRUE(check.at("detail").is_null()) << check;
}

/// What would have been right is in the details of a tutor's report only.
TEST(StudentProfile, TellsNoExpectedValue)
{
    std::string const seen = grade_example("student").report.dump();
    Json const tutor = grade_example("tutor").report;
    int values = 0;
    for (auto const& [name, function] : tutor.at("functions").items())
        for (auto const& check : function.at("checks")) {
            // What is right in a word or two may be in a hint, too.
            if (check.at("detail").is_null() || check.at("detail").get<std::string>().size() < 12)
                continue;
            std::string const expected = check.at("detail");
            EXPECT_EQ(seen.find(expected), std::string::npos) << expected;
            ++values;
        }
    EXPECT_GE(values, 2);
}

TEST(StudentProfile, SaysThatOnlyPublicChecksCount)
{
    EXPECT_NE(grade_example("student").out.find("Only the public checks are counted"), std::string::npos);
    EXPECT_EQ(grade_example("tutor").out.find("Only the public checks are counted"), std::string::npos);
}

TEST(StudentProfile, KeepsTheMaximum)
{
    TemporaryDirectory const place;
    Graded const graded = grade_file(reference_file(), place.path(), {"--profile", "student"});
    EXPECT_EQ(graded.report.at("points").at("earned"), 20) << function_table_of(graded.report);
    EXPECT_EQ(graded.report.at("points").at("max"), 20);
}
}  // namespace
}  // namespace testat
