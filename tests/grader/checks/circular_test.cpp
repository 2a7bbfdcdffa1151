#include "checks/circular.h"
#include "checks/check.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace testat {
namespace {
constexpr auto clamp = Function::wrap_clamp;
constexpr auto repeat = Function::wrap_repeat;
constexpr auto nearest = Function::evaluate_nearest;
constexpr auto bilinear = Function::evaluate_bilinear;

FunctionSet set_of(std::vector<Function> const& functions)
{
    FunctionSet set;
    for (Function f : functions)
        set = set.with(f);
    return set;
}

/// What each function answers alone, in no time.
Observations answered(Questions const& questions)
{
    Observations observations;
    for (auto const& group : questions.request.groups) {
        Answers answers{group, {}, {}};
        answers.status.ended = Ended::answered;
        observations.groups.emplace(group.name, answers);
    }
    return observations;
}

/// Asks one check of each, and has those crash that the rule names.
FunctionSet find(std::vector<Function> const& functions, bool (*crashes)(Function, FunctionSet from_upload),
                 Ended ended = Ended::signal, double cpu_s = 0)
{
    Questions questions;
    for (auto const& check : unit_checks())
        if (std::find(functions.begin(), functions.end(), check.function) != functions.end()) {
            Group group;
            group.name = check.name;
            group.under_test = check.function;
            questions.request.groups.push_back(group);
        }
    return find_circular(set_of(functions), answered(questions), questions, [&](Request const& request) {
        Observations observations;
        for (auto const& group : request.groups) {
            Answers answers{group, {}, {}};
            answers.status.ended = ended;
            answers.status.cpu_s = cpu_s;
            if (crashes(group.under_test, group.from_upload))
                observations.groups.emplace(group.name, answers);
        }
        return observations;
    });
}
}  // namespace

TEST(Circular, AreTwoThatAskEachOther)
{
    auto const both = [](Function f, FunctionSet from) {
        return (f == clamp || f == repeat) && from.has(clamp) && from.has(repeat);
    };
    EXPECT_EQ(find({clamp, repeat, nearest}, both), set_of({clamp, repeat}));
    EXPECT_EQ(find({clamp, nearest}, both), FunctionSet());
}

TEST(Circular, AreTwoThatGoRoundForEver)
{
    auto const both = [](Function, FunctionSet from) { return from.has(clamp) && from.has(repeat); };
    EXPECT_EQ(find({clamp, repeat}, both, Ended::timed_out, 5), set_of({clamp, repeat}));
}

TEST(Circular, IsNotWhatNoTimeIsLeftFor)
{
    auto const both = [](Function, FunctionSet from) { return from.has(clamp) && from.has(repeat); };
    EXPECT_EQ(find({clamp, repeat}, both, Ended::timed_out, 0), FunctionSet());
    EXPECT_EQ(find({clamp, repeat}, both, Ended::lost), FunctionSet());
}

TEST(Circular, AreThreeInARing)
{
    auto const ring = [](Function f, FunctionSet from) {
        return f != bilinear && from.has(clamp) && from.has(repeat) && from.has(nearest);
    };
    EXPECT_EQ(find({clamp, repeat, nearest, bilinear}, ring), set_of({clamp, repeat, nearest}));
}

TEST(Circular, IsNotWhatOnlyCallsOneOfThem)
{
    auto const caller = [](Function f, FunctionSet from) {
        bool const ring = from.has(clamp) && from.has(repeat);
        return ring && (f == clamp || f == repeat || f == nearest);
    };
    EXPECT_EQ(find({clamp, repeat, nearest}, caller), set_of({clamp, repeat}));
}

TEST(Circular, IsNotWhatCallsAMistakeThatNoCheckShows)
{
    auto const callers = [](Function f, FunctionSet from) {
        return (f == nearest || f == bilinear) && from.has(clamp);
    };
    EXPECT_EQ(find({clamp, nearest, bilinear}, callers), FunctionSet());
}

TEST(Circular, AreAskedInCompanyUnlessTheyAreSlow)
{
    Questions questions;
    for (Function f : {clamp, repeat, nearest}) {
        Group group;
        group.name = std::string(info(f).name);
        group.under_test = f;
        questions.request.groups.push_back(group);
    }
    Observations alone = answered(questions);
    alone.groups.at("evaluate_nearest").status.cpu_s = 2;
    Request request;
    ask_in_company(request, set_of({clamp, repeat, nearest}), alone, questions);
    ASSERT_EQ(request.groups.size(), 2u);
    for (auto const& group : request.groups)
        EXPECT_EQ(group.from_upload, set_of({clamp, repeat})) << group.name;
    Request nothing;
    ask_in_company(nothing, set_of({nearest}), alone, questions);
    EXPECT_TRUE(nothing.groups.empty());
}

TEST(Circular, ShowInCompany)
{
    UnitCheck const& check = unit_checks().front();
    Observations observations;
    EXPECT_FALSE(fail_in_company(observations, {}, {}));
    Answers crashed;
    crashed.status.ended = Ended::signal;
    observations.groups.emplace("in_company/" + check.name, crashed);
    EXPECT_TRUE(fail_in_company(observations, {}, {}));
}

TEST(Circular, EarnNothing)
{
    CheckResults results;
    for (Function f : {clamp, repeat, nearest}) {
        results.checks.emplace_back();
        results.checks.back().function = f;
        results.checks.back().passed = true;
    }
    take_credit(results, set_of({clamp, repeat}));
    EXPECT_FALSE(results.passing().has(clamp) || results.passing().has(repeat));
    EXPECT_TRUE(results.passing().has(nearest));
    EXPECT_NE(results.checks[0].trouble->en.find("wrap_repeat"), std::string::npos);
}
}  // namespace testat
