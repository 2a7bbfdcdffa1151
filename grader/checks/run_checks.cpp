#include "checks/run_checks.h"

#include "checks/check.h"
#include "checks/mistakes/mistake.h"
#include "checks/trouble.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <stdexcept>

namespace testat {
namespace {
/// A unit check as a GoogleTest case; its observation is the group of its own name.
class CheckCase : public testing::Test {
public:
    CheckCase(UnitCheck const& check, Observations const& observations, Textures const& textures,
              std::vector<CheckResult>& results)
        : check_(check), observations_(observations), textures_(textures), results_(results)
    {
    }

    void TestBody() override
    {
        CheckResult result;
        result.name = check_.name;
        result.function = check_.function;
        if (auto const* answers = observations_.find(check_.name))
            judge(*answers, result);
        else
            not_asked(result);
        EXPECT_TRUE(result.passed) << result.detail;
        results_.push_back(std::move(result));
    }

private:
    static void not_asked(CheckResult& result) { result.ended = Ended::lost; }

    void judge(Answers const& answers, CheckResult& result) const
    {
        result.ended = answers.status.ended;
        result.trouble = describe_trouble(answers.status);
        if (answers.status.ended != Ended::answered)
            return stopped(answers, result);
        Verdict const verdict = check_.judge(answers, textures_);
        result.passed = verdict.passed();
        result.error = verdict.error();
        if (!result.passed)
            mismatch(answers, verdict, result);
    }

    void stopped(Answers const& answers, CheckResult& result) const
    {
        result.detail = name_end(answers.status);
        if (answers.status.answered < answers.group.count)
            result.mismatch = Mismatch{describe_question(answers.group, answers.status.answered, textures_),
                                       name_end(answers.status), ""};
    }

    void mismatch(Answers const& answers, Verdict const& verdict, CheckResult& result) const
    {
        auto const& d = verdict.deviation();
        result.mismatch =
            Mismatch{describe_question(answers.group, verdict.question(), textures_), d.measured, d.expected};
        result.detail = d.expected;
        if (std::isfinite(d.in_bounds))
            result.detail += fmt::format(" (|error| / bound = {:.3g})", d.in_bounds);
    }

    UnitCheck const& check_;
    Observations const& observations_;
    Textures const& textures_;
    std::vector<CheckResult>& results_;
};

void register_case(UnitCheck const& check, Observations const& observations, Textures const& textures,
                   std::vector<CheckResult>& results)
{
    std::size_t const dot = check.name.find('.');
    testing::RegisterTest(check.name.substr(0, dot).c_str(), check.name.substr(dot + 1).c_str(), nullptr, nullptr,
                          __FILE__, __LINE__, [&check, &observations, &textures, &results]() -> testing::Test* {
                              return new CheckCase(check, observations, textures, results);
                          });
}

/// GoogleTest takes filters, shards and the like from the environment; a check that is left out would cost points.
void ignore_environment()
{
    for (char const* name :
         {"GTEST_TOTAL_SHARDS", "GTEST_SHARD_INDEX", "GTEST_SHARD_STATUS_FILE", "TEST_PREMATURE_EXIT_FILE"})
        unsetenv(name);
    GTEST_FLAG_SET(filter, "*");
    GTEST_FLAG_SET(repeat, 1);
    GTEST_FLAG_SET(output, "");
    GTEST_FLAG_SET(fail_fast, false);
    GTEST_FLAG_SET(break_on_failure, false);
    GTEST_FLAG_SET(throw_on_failure, false);
    GTEST_FLAG_SET(shuffle, false);
}

/// Our own exceptions pass through GoogleTest; nothing is printed.
void prepare_googletest()
{
    ignore_environment();
    int argc = 1;
    char program[] = "testat";
    char* argv[] = {program, nullptr};
    testing::InitGoogleTest(&argc, argv);
    GTEST_FLAG_SET(catch_exceptions, false);
    auto& listeners = testing::UnitTest::GetInstance()->listeners();
    delete listeners.Release(listeners.default_result_printer());
}

void register_checks(Rubric const& rubric, Observations const& observations, Textures const& textures,
                     std::vector<CheckResult>& results)
{
    for (auto const& function : rubric.functions)
        for (auto const& wanted : function.checks)
            for (auto const& check : unit_checks())
                if (check.name == wanted.name)
                    register_case(check, observations, textures, results);
}

std::size_t count_checks(Rubric const& rubric)
{
    std::size_t count = 0;
    for (auto const& function : rubric.functions)
        count += function.checks.size();
    return count;
}

}  // namespace

CheckResults check(Observations const& observations, Questions const& questions, Rubric const& rubric)
{
    CheckResults results;
    prepare_googletest();
    register_checks(rubric, observations, questions.request.textures, results.checks);
    [[maybe_unused]] int const failed = RUN_ALL_TESTS();  // what failed is in the results
    if (results.checks.size() != count_checks(rubric))
        throw std::runtime_error("not every check of the rubric was run");
    results.mistakes = name_mistakes(results, observations, questions.request.textures);
    return results;
}
}  // namespace testat
