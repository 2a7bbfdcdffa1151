#include "theory/barycentric.h"

#include "theory/formula.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>

namespace testat::theory {
namespace {
using Json = nlohmann::ordered_json;

Json const right = {{"areas",
                     {{"F1", "length(cross(B - P, C - P)) / 2"},
                      {"F2", "length(cross(C - P, A - P)) / 2"},
                      {"F3", "1/2 * |(A - P) × (B - P)|"}}},
                    {"lambda", {{"A", "F1 / (F1 + F2 + F3)"}, {"B", "F2 / F"}, {"C", "1 - lambda_A - lambda_B"}}},
                    {"P'", "lambda_A * A' + lambda_B * B' + lambda_C * C'"}};

/// The first mistake of each answer, by id of the answer; only of those that are not right.
std::map<std::string, std::string> mistakes_in(Json const& answers)
{
    std::map<std::string, std::string> mistakes;
    for (auto const& judgement : judge_barycentric(answers))
        if (judgement.verdict != Verdict::right)
            mistakes[judgement.id] = judgement.findings.empty() ? "unanswered" : judgement.findings[0].id;
    return mistakes;
}

using Mistakes = std::map<std::string, std::string>;

/// The right answers, but for one.
Mistakes mistakes_with(char const* place, std::string const& formula)
{
    Json answers = right;
    answers[Json::json_pointer(place)] = formula;
    return mistakes_in(answers);
}

TEST(Barycentric, AcceptsTheRightAnswers)
{
    EXPECT_EQ(mistakes_in(right), Mistakes());
}

/// Only the figure says which part is F1.
TEST(Barycentric, AcceptsEveryNamingOfTheParts)
{
    std::array<std::string, 3> parts{"area(P, B, C)", "area(P, C, A)", "area(P, A, B)"};
    std::array<int, 3> order{0, 1, 2};
    do {
        Json answers = right;
        for (int i = 0; i < 3; ++i) {
            answers["areas"]["F" + std::to_string(i + 1)] = parts[std::size_t(order[i])];
            answers["lambda"][corner_names[order[i]]] = fmt::format("F{} / F", i + 1);
        }
        EXPECT_EQ(mistakes_in(answers), Mistakes()) << order[0] << order[1] << order[2];
        answers.erase("areas");
        EXPECT_EQ(mistakes_in(answers), (Mistakes{{"F1", "taken_as"}, {"F2", "taken_as"}, {"F3", "taken_as"}}));
    } while (std::next_permutation(order.begin(), order.end()));
}

TEST(Barycentric, AcceptsOtherFormulas)
{
    EXPECT_EQ(mistakes_with("/lambda/A", "area(P, B, C) / area(A, B, C)"), Mistakes());
    EXPECT_EQ(
        mistakes_with("/lambda/A", "dot(cross(C-B, P-B), cross(B-A, C-A)) / dot(cross(B-A, C-A), cross(B-A, C-A))"),
        Mistakes());
    EXPECT_EQ(mistakes_with("/lambda/B", "1 - λ_A - λ_C"),
              (Mistakes{{"lambda_B", "circular"}, {"lambda_C", "circular"}}));
    EXPECT_EQ(mistakes_with("/P'", "A' + lambda_B * (B' - A') + lambda_C * (C' - A')"), Mistakes());
    EXPECT_EQ(mistakes_with("/P'", "(F1 * A' + F2 * B' + F3 * C') / (F1 + F2 + F3)"), Mistakes());
    EXPECT_EQ(mistakes_with("/areas/F1", "0.5 * |B-P| * |C-P| * sin(acos(dot(B-P, C-P) / (|B-P| * |C-P|)))"),
              Mistakes());
}

TEST(Barycentric, TakesUAndVApart)
{
    Json answers = right;
    answers["P'"] = {{"u", "lambda_A * A'.u + lambda_B * B'.u + lambda_C * C'.u"},
                     {"v", "lambda_A * A'.v + lambda_B * B'.v + lambda_C * C'.v"}};
    EXPECT_EQ(mistakes_in(answers), Mistakes());
    std::swap(answers["P'"]["u"], answers["P'"]["v"]);
    EXPECT_EQ(mistakes_in(answers), (Mistakes{{"P'", "uv_exchanged"}}));
    answers["P'"]["u"] = "";
    EXPECT_EQ(mistakes_in(answers), (Mistakes{{"P'", "unreadable"}}));
}

TEST(Barycentric, NamesMistakesOfAreas)
{
    auto const mistake = [](std::string const& formula) { return mistakes_with("/areas/F2", formula)["F2"]; };
    EXPECT_EQ(mistake("length(cross(C - P, A - P))"), "half_missing");
    EXPECT_EQ(mistake("-area(P, C, A)"), "sign");
    EXPECT_EQ(mistake("area(P, C, A) / 2"), "factor");
    EXPECT_EQ(mistake("cross(C - P, A - P).x"), "no_part");
    EXPECT_EQ(mistake("dot(cross(C - P, A - P), cross(C - P, A - P)) / 4"), "squared");
    EXPECT_EQ(mistake("area(A, B, C)"), "whole_triangle");
    EXPECT_EQ(mistake("area(A, B, C) - area(P, C, A)"), "two_parts");
    EXPECT_EQ(mistake("area(P, B, C)"), "same_triangle");
    EXPECT_EQ(mistake("cross(C - P, A - P) / 2"), "unreadable");
    EXPECT_EQ(mistake("0"), "no_part");
    EXPECT_EQ(mistake("F - F1 - F3"), "unreadable");
}

TEST(Barycentric, NamesMistakesOfCoordinates)
{
    auto const mistake = [](std::string const& formula) { return mistakes_with("/lambda/B", formula)["lambda_B"]; };
    EXPECT_EQ(mistake("F1 / F"), "exchanged");
    EXPECT_EQ(mistake("F2"), "not_divided");
    EXPECT_EQ(mistake("F2 / 2"), "not_divided");
    EXPECT_EQ(mistake("F2 / (2 * F)"), "half");
    EXPECT_EQ(mistake("-F2 / F"), "factor");
    EXPECT_EQ(mistake("F / F2"), "upside_down");
    EXPECT_EQ(mistake("F2 / (F1 + F3)"), "divided_by_the_rest");
    EXPECT_EQ(mistake("(F1 + F3) / F"), "complement");
    EXPECT_EQ(mistake("F1 / F2"), "wrong");
    EXPECT_EQ(mistake("1 / 3"), "wrong");
    EXPECT_EQ(mistake("F2 / (F - F1 - F2 - F3)"), "unreadable");
    EXPECT_EQ(mistake("sqrt(F1 - F2)"), "unreadable");
    EXPECT_EQ(mistake("lambda_B"), "circular");
    EXPECT_EQ(mistake("P"), "unreadable");
}

TEST(Barycentric, SaysThatCoordinatesMustAddUpToOne)
{
    auto const judgements = judge_coordinates({"F1 / F", "F2 / (2 * F)", "F3 / F"}, {0, 1, 2});
    ASSERT_EQ(judgements[1].findings.size(), 2u);
    EXPECT_EQ(judgements[1].findings[1].id, "sum");
    auto const turned = judge_coordinates({"F2 / F", "F3 / F", "F1 / F"}, {0, 1, 2});
    for (auto const& judgement : turned) {
        ASSERT_EQ(judgement.findings.size(), 1u);
        EXPECT_EQ(judgement.findings[0].id, "exchanged");
    }
}

TEST(Barycentric, NamesMistakesOfTextureCoordinates)
{
    auto const mistake = [](std::string const& formula) { return mistakes_with("/P'", formula)["P'"]; };
    EXPECT_EQ(mistake("lambda_B * A' + lambda_C * B' + lambda_A * C'"), "wrong_corners");
    EXPECT_EQ(mistake("lambda_B * A' + lambda_A * B' + lambda_C * C'"), "wrong_corners");
    EXPECT_EQ(mistake("(A' + B' + C') / 3"), "not_weighted");
    EXPECT_EQ(mistake("F1 * A' + F2 * B' + F3 * C'"), "not_divided");
    EXPECT_EQ(mistake("(lambda_A * A' + lambda_B * B' + lambda_C * C') / 3"), "factor");
    EXPECT_EQ(mistake("lambda_A * A' + lambda_B * B'"), "wrong");
    EXPECT_EQ(mistake("lambda_A * A + lambda_B * B + lambda_C * C"), "unreadable");
    EXPECT_EQ(mistake("lambda_A + lambda_B"), "unreadable");
}

/// One mistake counts once: what follows from a wrong answer is judged with the right one.
TEST(Barycentric, DoesNotCountAMistakeTwice)
{
    EXPECT_EQ(mistakes_with("/areas/F2", "area(P, C, A) * 2"), (Mistakes{{"F2", "half_missing"}}));
    EXPECT_EQ(mistakes_with("/lambda/A", "F1"), (Mistakes{{"lambda_A", "not_divided"}}));
}

TEST(Barycentric, SurvivesWhatIsNoFormula)
{
    for (char const* json : {"null", "3", "[]", R"({"areas": 1, "lambda": [], "P'": true})",
                             R"({"areas": {"F1": [[]], "F2": {}}, "lambda": {"A": false}, "P'": {"u": {}}})"})
        for (auto const& judgement : judge_barycentric(Json::parse(json)))
            EXPECT_NE(judgement.verdict, Verdict::right) << json;
}

TEST(Triangles, HaveAreasThatAddUp)
{
    for (auto const& t : random_triangles()) {
        EXPECT_NEAR(t.lambda[0] + t.lambda[1] + t.lambda[2], 1, 1e-12);
        Variables const v = variables_of(t);
        EXPECT_NEAR(Expression("area(P, B, C)").evaluate(v).v[0], t.part(0), 1e-9);
        EXPECT_NEAR(Expression("area(P, C, A)").evaluate(v).v[0], t.part(1), 1e-9);
        EXPECT_NEAR(Expression("area(P, A, B)").evaluate(v).v[0], t.part(2), 1e-9);
        EXPECT_NEAR(Expression("area(A, B, C)").evaluate(v).v[0], t.area, 1e-9);
    }
}
}  // namespace
}  // namespace testat::theory
