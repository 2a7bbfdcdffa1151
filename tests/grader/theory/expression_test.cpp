#include "theory/expression.h"

#include "checks/random.h"

#include <gtest/gtest.h>

#include <cmath>

namespace testat::theory {
namespace {
Variables const variables{{"A", Value::triple(1, 2, 3)},
                          {"B", Value::triple(3, 4, 4)},
                          {"A'", Value::pair(0.25, 0.5)},
                          {"lambda_A", Value::number(0.5)}};

double number(std::string const& text, Angles angles = Angles::radians)
{
    Value const value = Expression(text, angles).evaluate(variables);
    EXPECT_EQ(value.size, 1) << text;
    return value.v[0];
}

/// The English sentence; empty if there is nothing to refuse.
std::string refusal(std::string const& text)
{
    try {
        Expression(text).evaluate(variables);
        return "";
    } catch (Refused const& e) {
        EXPECT_FALSE(e.why.de.empty());
        return e.why.en;
    }
}

TEST(Expression, KnowsPrecedence)
{
    EXPECT_EQ(number("1 + 2 * 3"), 7);
    EXPECT_EQ(number("7 - 2 - 1"), 4);
    EXPECT_EQ(number("8 / 4 / 2"), 1);
    EXPECT_EQ(number("2 ^ 3 ^ 2"), 512);
    EXPECT_EQ(number("-2 ^ 2"), -4);
    EXPECT_EQ(number("(1 + 2) * -3"), -9);
    EXPECT_EQ(number("1e2 + .5"), 100.5);
}

TEST(Expression, KnowsAngles)
{
    EXPECT_NEAR(number("cos(60°)"), 0.5, 1e-12);
    EXPECT_NEAR(number("sin(pi / 2)"), 1, 1e-12);
    EXPECT_NEAR(number("cos(60)", Angles::degrees), 0.5, 1e-12);
    EXPECT_NEAR(number("sin(π/2)", Angles::degrees), 1, 1e-12);
    EXPECT_NEAR(number("cos(60°)", Angles::degrees), 0.5, 1e-12);
}

TEST(Expression, KnowsVectors)
{
    EXPECT_EQ(number("length(B - A)"), 3);
    EXPECT_EQ(number("|B − A|"), 3);
    EXPECT_EQ(number("dot(A, B)"), 23);
    EXPECT_EQ(number("A · B"), 23);
    EXPECT_EQ(number("(A × B).x"), -4);
    EXPECT_EQ(number("cross(A, B).y"), 5);
    EXPECT_EQ(number("A'.u + A′.v"), 0.75);
    EXPECT_EQ(number("λ_A * 2"), 1);
    EXPECT_EQ(number("½ * |A × B|"), number("sqrt(dot(cross(A, B), cross(A, B))) / 2"));
}

TEST(Expression, SaysWhereItCannotBeRead)
{
    EXPECT_NE(refusal("2 A").find("At character 3: an operator is missing before 'A'."), std::string::npos);
    EXPECT_NE(refusal("(1 + 2").find("At character 7: ')' is missing here"), std::string::npos);
    EXPECT_NE(refusal("1 +").find("missing here"), std::string::npos);
    EXPECT_NE(refusal("1 $ 2").find("At character 3: '$' is no part of a formula"), std::string::npos);
    EXPECT_NE(refusal("λλλ ☃").find("At character 5: '☃' is no part of a formula"), std::string::npos);
    EXPECT_NE(refusal("system(1)").find("no function 'system'"), std::string::npos);
    EXPECT_NE(refusal("Q + 1").find("no name 'Q' here; there are A, A', B, lambda_A"), std::string::npos);
    EXPECT_NE(refusal("1e999").find("too large"), std::string::npos);
    for (char const* text :
         {"", " ", ")", "|", "A.", "A.w", "cross(A)", "cross(A, B", "1 ° °°(", "*", "A'.z", ".", "'"})
        EXPECT_NE(refusal(text), "") << text;
}

TEST(Expression, DoesNotMixNumbersAndVectors)
{
    for (char const* text : {"A + 1", "A * B", "A ^ 2", "1 / A", "A - A'", "dot(A, A')", "cross(A', A')", "sqrt(A)",
                             "lambda_A.x", "A°", "sin(A)", "area(A, B, 1)"})
        EXPECT_NE(refusal(text), "") << text;
}

TEST(Expression, IsBounded)
{
    auto const repeated = [](std::string const& text, int times) {
        std::string all;
        for (int i = 0; i < times; ++i)
            all += text;
        return all;
    };
    EXPECT_NE(refusal(repeated("1+", 1'000'000) + "1").find("at most"), std::string::npos);
    EXPECT_NE(refusal(repeated("(", 900) + "1" + repeated(")", 900)).find("nested"), std::string::npos);
    EXPECT_NE(refusal(repeated("-", 1900) + "1").find("nested"), std::string::npos);
    EXPECT_NE(refusal("1" + repeated("^1", 900)).find("nested"), std::string::npos);
    EXPECT_NE(refusal(repeated("|", 1900)), "");
    EXPECT_NE(refusal(repeated("abs(", 400)), "");
    EXPECT_EQ(refusal("1" + repeated("+1", 999)), "");
    EXPECT_FALSE(std::isfinite(number(repeated("9^", 90) + "9")));
    EXPECT_TRUE(std::isnan(number("0 / 0")));
}

/// What it is made of are words of formulas, so that many of them get far.
std::string random_text(Random& random)
{
    char const* const words[] = {"A",  "B",  "A'", "lambda_A", "1", "2.5",    "+",    "-",       "*",     "/",
                                 "^",  "(",  ")",  ",",        "|", "cross(", "dot(", "length(", "sqrt(", "area(",
                                 ".x", ".u", "°",  "·",        "×", "λ",      "π",    " ",       "\xff",  "\xce"};
    std::string text;
    for (int i = random.integer(0, 30); i > 0; --i)
        text += words[random.integer(0, int(std::size(words)) - 1)];
    return text;
}

TEST(Expression, IsReadOrRefusedWhateverItIs)
{
    int read = 0;
    for (int seed = 0; seed < 20000; ++seed) {
        Random random(std::uint64_t(seed), "Expression");
        read += refusal(random_text(random)).empty();
    }
    EXPECT_GT(read, 100);
}
}  // namespace
}  // namespace testat::theory
