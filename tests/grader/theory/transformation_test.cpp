#include "theory/matrices.h"
#include "theory/slips.h"

#include "checks/random.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace testat::theory {
namespace {
using Json = nlohmann::ordered_json;

/// Worked out by hand: u1 = -u2, v1 = v2, w1 = -w2, and O1 is (1, -2, -1) in S2.
char const* const by_hand = "[[-1, 0, 0, 1], [0, 1, 0, -2], [0, 0, -1, -1], [0, 0, 0, 1]]";
char const* const basis1 = R"({"matrix": [[0, 1, 0, 0], [0, 0, 1, 0], [1, 0, 0, 0], [0, 0, 0, 1]]})";
char const* const basis2 = R"({"matrix": [[0, 1, 0, 0], [0, 0, -1, 0], [-1, 0, 0, 0], [0, 0, 0, 1]]})";
char const* const into_s2 =
    R"({"matrix": [[0, 1, 0, 0], [0, 0, -1, 0], [-1, 0, 0, 0], [0, 0, 0, 1]], "inverse": true, "meaning": "in S2"})";
char const* const origin = R"({"translate": [-2, 1, -1]})";

Judgement judged(std::string const& m, std::string const& factors)
{
    auto const all = judge_transformation({{"M", Json::parse(m)}, {"factors", Json::parse(factors)}});
    EXPECT_EQ(all.size(), 2u);
    return m == "null" ? all.at(1) : all.at(0);
}

std::string mistake_in(Judgement const& judgement)
{
    return judgement.findings.empty() ? "" : judgement.findings[0].id;
}

std::string mistake_in_matrix(std::string const& m)
{
    return mistake_in(judged(m, "null"));
}

template <typename... Strings>
std::string mistake_in_product(Strings const&... factors)
{
    return mistake_in(judged("null", fmt::format("[{}]", fmt::join(std::vector<std::string>{factors...}, ","))));
}

TEST(Transformation, AcceptsTheMatrixWorkedOutByHand)
{
    EXPECT_EQ(judged(by_hand, "null").verdict, Verdict::right);
    EXPECT_EQ(judged(R"json([["cos(180°)", 0, "sin(pi)", 1], [0, "2/2", 0, "-sqrt(4)"],
                             ["-sin(180°)", 0, "-1", -1], [0, 0, "0", "1.0"]])json",
                     "null")
                  .verdict,
              Verdict::right);
}

TEST(Transformation, AcceptsEveryFactorisation)
{
    EXPECT_EQ(mistake_in_product(into_s2, origin, basis1), "");
    EXPECT_EQ(mistake_in_product(R"({"translate": [1, -2, -1]})", R"({"rotate": {"axis": "v", "degrees": 180}})"), "");
    EXPECT_EQ(
        mistake_in_product(R"({"rotate": {"axis": [0, 2, 0], "degrees": "-180"}})", R"({"translate": [-1, -2, 1]})"),
        "");
    EXPECT_EQ(mistake_in_product(R"({"translate": [1, -2, -1]})", R"({"scale": [-1, 1, -1]})"), "");
    EXPECT_EQ(mistake_in_product(R"({"translate": [1, -2, -1]})", R"({"rotate": {"axis": "x", "degrees": 180}})",
                                 R"({"rotate": {"axis": "z", "degrees": 180}})"),
              "");
}

TEST(Transformation, AcceptsRandomFactorisations)
{
    for (int seed = 0; seed < 300; ++seed) {
        Random random(std::uint64_t(seed), "Factorisations");
        Json factors = Json::array();
        for (int i = random.integer(1, 3); i > 0; --i) {
            factors.push_back({{"rotate",
                                {{"axis", {random.uniform(0.1, 1), random.uniform(-1, 1), random.uniform(-1, 1)}},
                                 {"degrees", random.uniform(-360, 360)}}}});
            factors.push_back({{"translate", {random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-9, 9)}}});
        }
        for (auto i = factors.size(); i-- > 0;) {  // and back again
            factors.push_back(factors[i]);
            factors.back()["inverse"] = true;
        }
        factors.push_back({{"matrix", Json::parse(by_hand)}});
        EXPECT_EQ(mistake_in(judged("null", factors.dump())), "") << seed;
    }
}

TEST(Transformation, NamesMistakesOfTheMatrix)
{
    EXPECT_EQ(mistake_in_matrix("[[-1, 0, 0, 1], [0, 1, 0, 2], [0, 0, -1, -1], [0, 0, 0, 1]]"), "inverse");
    EXPECT_EQ(mistake_in_matrix("[[-1, 0, 0, 0], [0, 1, 0, 0], [0, 0, -1, 0], [1, -2, -1, 1]]"), "transposed");
    EXPECT_EQ(mistake_in_matrix("[[-1, 0, 0, 0], [0, 1, 0, 0], [0, 0, -1, 0], [0, 0, 0, 1]]"), "no_translation");
    EXPECT_EQ(mistake_in_matrix("[[-1, 0, 0, -1], [0, 1, 0, 2], [0, 0, -1, 1], [0, 0, 0, 1]]"), "translation_sign");
    EXPECT_EQ(mistake_in_matrix("[[-1, 0, 0, -2], [0, 1, 0, 1], [0, 0, -1, -1], [0, 0, 0, 1]]"),
              "translation_not_rotated");
    EXPECT_EQ(mistake_in_matrix("[[-1, 0, 0, -1], [0, 1, 0, -2], [0, 0, -1, 1], [0, 0, 0, 1]]"), "translation_in_s1");
    EXPECT_EQ(mistake_in_matrix("[[1, 0, 0, -2], [0, 1, 0, 1], [0, 0, 1, -1], [0, 0, 0, 1]]"), "no_rotation");
    EXPECT_EQ(mistake_in_matrix("[[1, 0, 0, 1], [0, 1, 0, -2], [0, 0, -1, -1], [0, 0, 0, 1]]"), "axis_sign");
    EXPECT_EQ(mistake_in_matrix("[[-1, 0, 0, 1], [0, 1, 0, -2], [0, 0, -1, 1], [0, 0, 0, 1]]"), "component_sign");
    EXPECT_EQ(mistake_in_matrix("[[-1, 0, 0, 1], [0, 1, 0, -2], [0, 0, -1, -1], [0, 0, 0, 0]]"), "homogeneous_row");
    EXPECT_EQ(mistake_in_matrix("[[0, 1, 0, 1], [-1, 0, 0, -2], [0, 0, -1, -1], [0, 0, 0, 1]]"), "handedness");
    EXPECT_EQ(mistake_in_matrix("[[-2, 0, 0, 1], [0, 1, 0, -2], [0, 0, -1, -1], [0, 0, 0, 1]]"), "not_orthonormal");
    EXPECT_EQ(mistake_in_matrix("[[1, 0, 0, 1], [0, -1, 0, -2], [0, 0, -1, -1], [0, 0, 0, 1]]"), "columns");
    EXPECT_EQ(mistake_in_matrix("[[-1, 0, 0, 7], [0, 1, 0, -2], [0, 0, -1, -1], [0, 0, 0, 1]]"), "translation");
}

TEST(Transformation, NamesSeveralMistakesOfOneMatrix)
{
    Judgement const both = judged("[[1, 0, 0, 0], [0, -1, 0, 0], [0, 0, -1, 0], [0, 0, 1, 1]]", "null");
    ASSERT_EQ(both.findings.size(), 3u);
    EXPECT_EQ(both.findings[0].id, "homogeneous_row");
    EXPECT_EQ(both.findings[1].id, "columns");
    EXPECT_EQ(both.findings[2].id, "no_translation");
}

TEST(Transformation, NamesTheFactorThatIsWrong)
{
    EXPECT_EQ(mistake_in_product(basis1, origin, into_s2), "order_reversed");
    EXPECT_EQ(mistake_in_product(origin, into_s2, basis1), "order");
    EXPECT_EQ(mistake_in_product(into_s2, R"({"translate": [2, -1, 1]})", basis1), "translation_sign");
    EXPECT_EQ(mistake_in_product(basis2, origin, basis1), "factor_inverted");
    EXPECT_EQ(mistake_in_product(into_s2, origin, basis1, R"({"scale": [1, 2, 1]})"), "factor_too_many");
    EXPECT_EQ(mistake_in_product(into_s2, basis1), "no_translation");
    EXPECT_EQ(mistake_in_product(origin, basis1), "ends_in_the_world");
    EXPECT_EQ(mistake_in_product(R"({"rotate": {"axis": "y", "degrees": 180}})"), "no_translation");
    Judgement const inverted = judged("null", fmt::format("[{}, {}, {}]", basis2, origin, basis1));
    EXPECT_NE(inverted.findings.at(0).text.en.find("Factor 1"), std::string::npos) << inverted.findings[0].text.en;
}

/// basis1^-1 T(-O1) basis2.
TEST(Transformation, NamesTheProductThatLeadsBack)
{
    std::string const back1 = std::string(basis1).substr(0, std::string(basis1).size() - 1) + R"(, "inverse": true})";
    EXPECT_EQ(mistake_in_product(back1, R"({"translate": [2, -1, 1]})", basis2), "inverse");
}

TEST(Transformation, NamesAnglesWithoutTheirUnit)
{
    EXPECT_EQ(mistake_in_matrix(R"json([["cos(180)", 0, "sin(180)", 1], [0, 1, 0, -2],
                                        ["-sin(180)", 0, "cos(180)", -1], [0, 0, 0, 1]])json"),
              "radians");
}

TEST(Transformation, SaysWhatCannotBeRead)
{
    for (char const* m : {"1", "\"M\"", "{}", "[[1, 2], [3, 4]]", "[[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]]",
                          R"([[1, "", 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])",
                          R"([[1, "1/0", 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])",
                          R"([[1, "x", 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])",
                          "[[1, [], 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, true]]"})
        EXPECT_EQ(judged(m, "null").verdict, Verdict::unreadable) << m;
    for (char const* factor :
         {"1", "{}", R"({"translate": [1, 2]})", R"({"translate": 1})", R"({"turn": 1})",
          R"({"scale": 1, "translate": [1, 1, 1]})", R"({"rotate": 90})", R"({"rotate": {"axis": "q", "degrees": 9}})",
          R"({"rotate": {"axis": [0, 0, 0], "degrees": 9}})", R"({"rotate": {"axis": "x", "radians": 9}})",
          R"({"scale": 0, "inverse": true})", R"({"scale": 1, "inverse": 1})",
          R"({"scale": [1e308, 1e308, "1e308*10"]})"})
        EXPECT_EQ(judged("null", fmt::format("[{}]", factor)).verdict, Verdict::unreadable) << factor;
}

TEST(Transformation, SaysWhereItCannotBeRead)
{
    Judgement const entry = judged(R"([[1, 0, 0, 0], [0, 1, 0, "2 3"], [0, 0, 1, 0], [0, 0, 0, 1]])", "null");
    EXPECT_NE(entry.findings.at(0).text.en.find("Row 2, column 4: At character 3: "), std::string::npos)
        << entry.findings[0].text.en;
    Judgement const factor = judged("null", fmt::format("[{}, {{\"translat\": [1, 2, 3]}}]", origin));
    EXPECT_NE(factor.findings.at(0).text.en.find("Factor 2: "), std::string::npos) << factor.findings[0].text.en;
}

TEST(Transformation, SurvivesOverflow)
{
    std::string const huge = R"({"scale": 1e300})";
    EXPECT_NE(mistake_in_product(huge, huge, huge), "");
    EXPECT_EQ(judged("null", "[" + std::string(26, '1') + "]").verdict, Verdict::unreadable);
}

TEST(Transformation, LeavesOpenWhatIsBlank)
{
    for (char const* m :
         {"null", "[]", "\" \"", R"([["", "", "", ""], ["", "", "", ""], ["", "", "", ""], ["", "", "", ""]])"})
        EXPECT_EQ(judge_transformation({{"M", Json::parse(m)}}).at(0).verdict, Verdict::unanswered) << m;
    EXPECT_EQ(judge_transformation(Json(3)).at(1).verdict, Verdict::unanswered);
}

TEST(Slips, AreTenAtLeastAndAllDifferent)
{
    EXPECT_GE(slips().size(), 10u);
    for (auto const& slip : slips()) {
        EXPECT_FALSE(alike(slip.matrix, solution())) << slip.finding.id;
        EXPECT_EQ(diagnose(slip.matrix).at(0).id, slip.finding.id);
        EXPECT_FALSE(slip.finding.text.de.empty() || slip.finding.text.en.empty()) << slip.finding.id;
    }
}

/// An answer that is wrong in some entry is never called right, and something is said of it.
TEST(Slips, NeverExplainTheSolution)
{
    for (int seed = 0; seed < 2000; ++seed) {
        Random random(std::uint64_t(seed), "Slips");
        glm::dmat4 matrix = solution();
        for (int i = random.integer(1, 3); i > 0; --i)
            matrix[random.integer(0, 3)][random.integer(0, 3)] = random.integer(-2, 2);
        EXPECT_EQ(diagnose(matrix).empty(), alike(matrix, solution())) << seed;
    }
}
}  // namespace
}  // namespace testat::theory
