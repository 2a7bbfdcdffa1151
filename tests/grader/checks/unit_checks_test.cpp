#include "checks/check.h"
#include "installation.h"
#include "reference_answers.h"
#include "rubric/rubric.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace testat {
namespace {
constexpr std::uint64_t seeds = 20;

/// Calls `test(check, seed, textures, questions)` for every check and seed; a failure names both.
template <typename Test>
void for_every_check(Test const& test)
{
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        Textures const textures = make_test_textures(seed);
        for (auto const& check : unit_checks()) {
            SCOPED_TRACE(check.name + ", seed " + std::to_string(seed));
            test(check, seed, textures, questions_of(check, seed, textures));
        }
    }
}

/// Where the answers of a check are counted in whole numbers.
bool counts(UnitCheck const& check)
{
    static std::set<std::string> const names = {"Intersect.HitsAndMisses", "Intersect.MovedScene",
                                                "CreateMipmap.SquareSizes"};
    return check.function == Function::wrap_clamp || check.function == Function::wrap_repeat ||
           names.count(check.name) > 0;
}

/// First word of an answer that is a float.
std::size_t first_float(Kind kind)
{
    return kind == Kind::mipmap ? MipmapLayout::header_words : kind == Kind::intersect ? 1 : 0;
}

/// Multiplies the floats of one answer, or adds one to its first word.
void spoil(UnitCheck const& check, std::uint32_t index, float factor, Answers& answers)
{
    std::uint32_t* words = &answers.words[std::size_t(index) * answers.group.words_per_answer];
    if (counts(check)) {
        ++words[0];
        return;
    }
    for (std::size_t i = first_float(answers.group.kind); i < answers.group.words_per_answer; ++i) {
        float value;
        std::memcpy(&value, words + i, sizeof value);
        value *= factor;
        std::memcpy(words + i, &value, sizeof value);
    }
}

bool is_zero(Answers const& answers, std::uint32_t index)
{
    auto const* begin = &answers.words[std::size_t(index) * answers.group.words_per_answer];
    return std::all_of(begin, begin + answers.group.words_per_answer, [](std::uint32_t word) { return word == 0; });
}

/// A question whose answer says something: a ray that misses has no position, what is so near that only few digits of
/// its distance are left hides a small error, and what is outside a texture is zero.
std::uint32_t telling_question(Random& random, UnitCheck const& check, Answers const& answers)
{
    for (;;) {
        auto const index = std::uint32_t(random.integer(0, int(answers.group.count) - 1));
        bool const is_silent = answers.group.kind == Kind::intersect &&
                               (integer(answers, index) == 0 || floats<1>(answers, index, 1)[0] < 0.01f);
        if (counts(check) || (!is_silent && !is_zero(answers, index)))
            return index;
    }
}
}  // namespace

TEST(UnitChecks, AreThoseOfTheRubric)
{
    std::set<std::string> checks, wanted;
    for (auto const& check : unit_checks())
        EXPECT_TRUE(checks.insert(check.name).second) << check.name << " is there twice";
    for (auto const& function : read_rubric(installation().rubric).functions)
        for (auto const& check : function.checks)
            wanted.insert(check.name);
    EXPECT_EQ(checks, wanted);
}

TEST(UnitChecks, StandInTheRubricUnderTheirFunction)
{
    for (auto const& function : read_rubric(installation().rubric).functions)
        for (auto const& wanted : function.checks)
            for (auto const& check : unit_checks())
                EXPECT_TRUE(check.name != wanted.name || check.function == function.function) << check.name;
}

TEST(UnitChecks, AskWellFormedQuestions)
{
    for_every_check([](UnitCheck const&, std::uint64_t, Textures const&, Group const& group) {
        EXPECT_GT(group.count, 0u);
        EXPECT_GT(group.words_per_answer, 0u);
        EXPECT_EQ(group.questions.size(), std::size_t(group.count) * question_bytes(group.kind));
    });
}

TEST(UnitChecks, AcceptTheReference)
{
    for_every_check([](UnitCheck const& check, std::uint64_t, Textures const& textures, Group const& group) {
        Verdict const verdict = check.judge(reference_answers(group, textures), textures);
        EXPECT_TRUE(verdict.passed()) << describe_question(group, verdict.question(), textures) << "\nmeasured "
                                      << verdict.deviation().measured << "\nexpected " << verdict.deviation().expected
                                      << "\nin bounds " << verdict.deviation().in_bounds;
    });
}

TEST(UnitChecks, RejectWordsThatWereNeverWritten)
{
    for_every_check([](UnitCheck const& check, std::uint64_t, Textures const& textures, Group const& group) {
        EXPECT_FALSE(check.judge(constant_answers(group, unanswered), textures).passed());
    });
}

TEST(UnitChecks, RejectZeros)
{
    for_every_check([](UnitCheck const& check, std::uint64_t, Textures const& textures, Group const& group) {
        bool const zero_is_right = check.name == "WrapClamp.NegativeIndices";
        EXPECT_EQ(check.judge(constant_answers(group, 0), textures).passed(), zero_is_right);
    });
}

TEST(UnitChecks, RejectOneWrongAnswer)
{
    for_every_check([](UnitCheck const& check, std::uint64_t seed, Textures const& textures, Group const& group) {
        Answers answers = reference_answers(group, textures);
        Random random(seed, "wrong");
        std::uint32_t const index = telling_question(random, check, answers);
        spoil(check, index, 1.01f, answers);
        EXPECT_FALSE(check.judge(answers, textures).passed()) << describe_question(group, index, textures);
    });
}

TEST(UnitChecks, RejectOneAnswerThatIsNotFinite)
{
    for (float wrong : {NAN, HUGE_VALF, -HUGE_VALF})
        for_every_check([=](UnitCheck const& check, std::uint64_t seed, Textures const& textures, Group const& group) {
            Answers answers = reference_answers(group, textures);
            Random random(seed, "not finite");
            spoil(check, telling_question(random, check, answers), wrong, answers);
            EXPECT_FALSE(check.judge(answers, textures).passed()) << wrong;
        });
}

TEST(UnitChecks, NameTheWrongAnswer)
{
    for_every_check([](UnitCheck const& check, std::uint64_t seed, Textures const& textures, Group const& group) {
        Answers answers = reference_answers(group, textures);
        Random random(seed, "named");
        std::uint32_t const index = telling_question(random, check, answers);
        spoil(check, index, 1.5f, answers);
        Verdict const verdict = check.judge(answers, textures);
        bool const pairs =
            check.name.find("Gradients") != std::string::npos || check.name == "EvaluateBilinear.NegativeCoordinates";
        if (!check.is_metamorphic) {  // there another question of the same relation may be named
            EXPECT_EQ(verdict.question(), pairs ? index | 1 : index);
        }
        EXPECT_NE(verdict.deviation().measured, "");
        EXPECT_NE(verdict.deviation().expected, "");
    });
}

TEST(UnitChecks, AskTheSameForTheSameSeed)
{
    for_every_check([](UnitCheck const& check, std::uint64_t seed, Textures const&, Group const& group) {
        EXPECT_EQ(questions_of(check, seed, make_test_textures(seed)).questions, group.questions);
    });
}

TEST(UnitChecks, AskSomethingElseForAnotherSeed)
{
    for (auto const& check : unit_checks()) {
        bool const always_the_same = check.function == Function::create_mipmap;  // there the texels change
        bool const same = questions_of(check, 1, make_test_textures(1)).questions ==
                          questions_of(check, 2, make_test_textures(2)).questions;
        if (check.name != "CreateMipmap.LinearInTheTexture") {  // the same three textures, in any order
            EXPECT_EQ(same, always_the_same) << check.name;
        }
    }
}

TEST(UnitChecks, DescribeEveryQuestionInWords)
{
    Textures const textures = make_test_textures(1);
    for (auto const& check : unit_checks()) {
        Group const group = questions_of(check, 1, textures);
        std::string const text = describe_question(group, group.count - 1, textures);
        EXPECT_GT(text.size(), 5u) << check.name;
        EXPECT_EQ(text.find('\n'), std::string::npos) << check.name;
    }
}
}  // namespace testat
