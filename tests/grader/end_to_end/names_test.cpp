// A check has one name: unit check, rubric key and group of questions. So has a picture.
#include "checks/check.h"
#include "checks/mistakes/mistake.h"
#include "checks/run_checks.h"
#include "installation.h"
#include "rubric/rubric.h"

#include <cglib/rt/assignment_images.h>

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace testat {
namespace {
using Names = std::set<std::string>;

Rubric rubric()
{
    return read_rubric(installation().rubric);
}

std::map<std::string, Function> checks_of_rubric()
{
    std::map<std::string, Function> checks;
    for (auto const& function : rubric().functions)
        for (auto const& check : function.checks)
            EXPECT_TRUE(checks.emplace(check.name, function.function).second) << check.name << " is there twice";
    return checks;
}

Names pictures_of_rubric()
{
    Names names;
    for (auto const& function : rubric().functions)
        names.insert(function.pictures.begin(), function.pictures.end());
    return names;
}

TEST(Names, OfUnitChecksAndOfTheRubricAreOneSet)
{
    std::map<std::string, Function> checks;
    for (auto const& check : unit_checks())
        EXPECT_TRUE(checks.emplace(check.name, check.function).second) << check.name << " is there twice";
    EXPECT_EQ(checks, checks_of_rubric());
}

TEST(Names, OfMistakesAndOfTheRubricAreOneSet)
{
    std::map<std::string, Function> known, worded;
    for (auto const& mistake : mistakes())
        EXPECT_TRUE(known.emplace(mistake.id, mistake.function).second) << mistake.id << " is there twice";
    for (auto const& function : rubric().functions)
        for (auto const& mistake : function.mistakes)
            EXPECT_TRUE(worded.emplace(mistake.id, function.function).second) << mistake.id << " is there twice";
    EXPECT_EQ(known, worded);
}

TEST(Names, OfPicturesInTheRubricAreThoseOfTheFramework)
{
    Names made{"miplevels"};
    for (auto const& image : assignment_images())
        made.insert(image.name);
    EXPECT_EQ(pictures_of_rubric(), made);
}

TEST(Names, OfPicturesHaveAnEnvelope)
{
    for (auto const& name : pictures_of_rubric())
        EXPECT_TRUE(std::filesystem::exists(installation().envelopes / (name + ".envelope"))) << name;
}

TEST(Names, OfGroupsAreThoseOfChecks)
{
    Names wanted;
    for (auto const& [name, function] : checks_of_rubric())
        wanted.insert(name);
    Names asked;
    for (auto const& group : make_questions(rubric(), FunctionSet::all(), 1).request.groups)
        EXPECT_TRUE(asked.insert(group.name).second) << group.name << " is asked twice";
    EXPECT_EQ(asked, wanted);
}

/// A mistake in a function with one check only would cost all of it or nothing.
TEST(Names, OfFunctionsHaveSeveralChecks)
{
    for (auto const& function : rubric().functions)
        EXPECT_GE(function.checks.size(), 2u) << info(function.function).name;
}
}  // namespace
}  // namespace testat
