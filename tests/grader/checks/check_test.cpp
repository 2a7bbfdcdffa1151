#include "checks/check.h"

#include <gtest/gtest.h>

#include <limits>

namespace testat {
namespace {
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

double in_bounds(double measured, double expected, double bound)
{
    return compare({measured}, {expected}, {bound}).in_bounds;
}
}  // namespace

TEST(Compare, CountsInUnitsOfTheBound)
{
    EXPECT_EQ(in_bounds(1.5, 1, 1), 0.5);
    EXPECT_EQ(in_bounds(0.5, 1, 0.25), 2);
    EXPECT_EQ(in_bounds(1, 1, 0), 0);
}

TEST(Compare, AllowsNothingWithoutABound)
{
    EXPECT_GT(in_bounds(1.0000001, 1, 0), 1);
    EXPECT_GT(in_bounds(2, 1, -5), 1);
    EXPECT_GT(in_bounds(2, 1, nan), 1);
}

TEST(Compare, RefusesWhatIsNotFiniteWhateverTheBound)
{
    for (double wrong : {nan, infinity, -infinity})
        for (double bound : {0.0, 1.0, 1e300, infinity}) {
            EXPECT_EQ(in_bounds(wrong, 1, bound), infinity);
            EXPECT_EQ(in_bounds(wrong, wrong, bound), infinity);
        }
}

TEST(Compare, KeepsTheWorstComponent)
{
    EXPECT_EQ(compare({1, 2, 3}, {1.5, 1, 3}, {1, 0.25, 0}).in_bounds, 4);
    EXPECT_EQ(compare({nan, 2}, {1, 1}, {1, 1}).in_bounds, infinity);
    EXPECT_EQ(compare({2, nan}, {1, 1}, {1, 1}).in_bounds, infinity);
}

TEST(Compare, SaysWhatItHasCompared)
{
    Deviation const d = compare({1, 0.5}, {2, 3}, {1, 1});
    EXPECT_EQ(d.measured, "(1, 0.5)");
    EXPECT_EQ(d.expected, "(2, 3)");
}

TEST(Verdict, PassesUpToTheBound)
{
    Verdict verdict;
    EXPECT_TRUE(verdict.passed());
    verdict.offer(3, {1, "", ""});
    EXPECT_TRUE(verdict.passed());
    verdict.offer(4, {1.0000001, "", ""});
    EXPECT_FALSE(verdict.passed());
    EXPECT_EQ(verdict.question(), 4u);
}

TEST(Verdict, KeepsTheWorst)
{
    Verdict verdict;
    verdict.offer(1, {2, "two", ""});
    verdict.offer(2, {5, "five", ""});
    verdict.offer(3, {3, "three", ""});
    EXPECT_EQ(verdict.question(), 2u);
    EXPECT_EQ(verdict.deviation().measured, "five");
}

TEST(Verdict, TakesNaNForTheWorst)
{
    Verdict verdict;
    verdict.offer(1, {1e300, "", ""});
    verdict.offer(2, {nan, "NaN", ""});
    verdict.offer(3, {1e301, "", ""});
    EXPECT_EQ(verdict.question(), 2u);
}

TEST(FormatVector, WritesOneNumberWithoutBrackets)
{
    EXPECT_EQ(format_vector({0.25}), "0.25");
    EXPECT_EQ(format_vector({0.25, -1, 3}), "(0.25, -1, 3)");
    EXPECT_EQ(format_vector({nan, infinity}), "(nan, inf)");
}

TEST(MakeGroup, KeepsItsQuestions)
{
    Group const group = make_group(Kind::wrap, std::vector<WrapQuestion>{{1, 2}, {-3, 4}});
    EXPECT_EQ(group.count, 2u);
    EXPECT_EQ(group.words_per_answer, 1u);
    EXPECT_EQ(question<WrapQuestion>(group, 1).val, -3);
    EXPECT_EQ(question<WrapQuestion>(group, 1).size, 4);
}

TEST(DescribeQuestion, SaysWhatToTry)
{
    Group const group = make_group(Kind::wrap, std::vector<WrapQuestion>{{-7, 6}});
    EXPECT_EQ(describe_question(group, 0, {}), "val = -7, size = 6");
}

TEST(DescribeQuestion, NamesSizeLevelAndUv)
{
    Group group = make_group(Kind::lookup, std::vector<LookupQuestion>{{1, 2, {0.5f, 0.25f}, {0.125f, 0}}});
    group.under_test = Function::evaluate_bilinear;
    EXPECT_EQ(describe_question(group, 0, make_test_textures(1)), "W x H = 32 x 8, level = 2, uv = (0.5, 0.25)");
    group.under_test = Function::evaluate_trilinear;
    EXPECT_EQ(describe_question(group, 0, make_test_textures(1)),
              "W x H = 32 x 8, uv = (0.5, 0.25), dudv = (0.125, 0)");
}
}  // namespace testat
