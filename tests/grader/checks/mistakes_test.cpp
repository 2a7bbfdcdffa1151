#include "checks/mistakes/mistake.h"

#include "reference_answers.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace testat {
namespace {
/// Answers of one function's checks, as if these had failed.
struct Asked {
    Textures textures;
    CheckResults results;
    Observations observations;

    std::map<Function, std::string> names() const { return name_mistakes(results, observations, textures); }
};

Asked ask_reference(std::uint64_t seed, bool passed)
{
    Asked asked{make_test_textures(seed), {}, {}};
    for (auto const& check : unit_checks()) {
        CheckResult result;
        result.name = check.name;
        result.function = check.function;
        result.passed = passed;
        asked.results.checks.push_back(result);
        asked.observations.groups[check.name] =
            reference_answers(questions_of(check, seed, asked.textures), asked.textures);
    }
    return asked;
}

/// wrap_repeat answered by `wrong`.
Asked ask_wrap_repeat(int (*wrong)(int val, int size))
{
    Asked asked = ask_reference(1, true);
    for (auto& check : asked.results.checks)
        if (check.function == Function::wrap_repeat) {
            check.passed = false;
            Answers& answers = asked.observations.groups[check.name];
            for (std::uint32_t i = 0; i < answers.group.count; ++i) {
                auto const q = question<WrapQuestion>(answers.group, i);
                answers.words[i] = std::uint32_t(wrong(q.val, q.size));
            }
        }
    return asked;
}

int abs_of_remainder(int val, int size)
{
    return std::abs(val % size);
}

/// The first lines of the corpus's wrong files, which say what must be named.
std::string verdicts()
{
    std::string all;
    for (auto const& file : std::filesystem::directory_iterator(TESTAT_REPOSITORY "/tests/submissions/wrong")) {
        std::ifstream in(file.path());
        std::string first;
        std::getline(in, first);
        all += first;
    }
    return all;
}

std::map<Function, std::string> const repeat_abs{{Function::wrap_repeat, "repeat_abs"}};
}  // namespace

TEST(Mistakes, HaveNoNameForWhatIsRight)
{
    std::map<Function, std::string> const nothing;
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        EXPECT_EQ(ask_reference(seed, true).names(), nothing) << seed;
        EXPECT_EQ(ask_reference(seed, false).names(), nothing) << seed;
    }
}

TEST(Mistakes, AreNamedWhenTheyExplainEveryAnswer)
{
    EXPECT_EQ(ask_wrap_repeat(abs_of_remainder).names(), repeat_abs);
}

TEST(Mistakes, AreNotNamedWhenOneAnswerSpeaksAgainstThem)
{
    Asked asked = ask_wrap_repeat(abs_of_remainder);
    for (auto const& check : unit_checks())
        if (check.function == Function::wrap_repeat) {
            std::uint32_t& word = asked.observations.groups[check.name].words.back();
            ++word;
            EXPECT_TRUE(asked.names().empty()) << check.name;
            --word;
        }
    EXPECT_EQ(asked.names(), repeat_abs);
}

TEST(Mistakes, AreNotNamedForACrashThatTheyDoNotPredict)
{
    Asked asked = ask_wrap_repeat(abs_of_remainder);
    Answers& answers = asked.observations.groups["WrapRepeat.NegativeIndices"];
    answers.status.ended = Ended::signal;
    answers.status.answered = 100;
    EXPECT_TRUE(asked.names().empty());
}

TEST(Mistakes, AreProvedByFilesOfTheCorpus)
{
    std::string const all = verdicts();
    for (auto const& mistake : mistakes()) {
        std::string const named = '"' + std::string(info(mistake.function).name) + "\": \"" + mistake.id + '"';
        EXPECT_NE(all.find(named), std::string::npos) << named;
    }
}

TEST(Mistakes, OfALevelThatIsNotThereMayEndInACrash)
{
    Asked asked = ask_reference(1, true);
    for (auto& check : asked.results.checks)
        check.passed = check.name != "EvaluateTrilinear.LastLevel";
    Answers& answers = asked.observations.groups["EvaluateTrilinear.LastLevel"];
    answers.status.ended = Ended::signal;
    answers.status.answered = 0;
    std::map<Function, std::string> const expected{{Function::evaluate_trilinear, "trilinear_crashes_at_last_level"}};
    EXPECT_EQ(asked.names(), expected);
    answers.status.ended = Ended::exception;  // of at()
    EXPECT_EQ(asked.names(), expected);
    answers.status.ended = Ended::exit;
    EXPECT_TRUE(asked.names().empty());
}
}  // namespace testat
