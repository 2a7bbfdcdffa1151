#include "theory/theory.h"

#include "report/wrap.h"

#include <gtest/gtest.h>

#include <sstream>

namespace testat::theory {
namespace {
Report parsed(std::string const& text)
{
    return parse_answers(text, "answers.json");
}

std::string refusal(std::string const& bytes)
{
    try {
        parsed(bytes);
        return "";
    } catch (std::invalid_argument const& e) {
        return e.what();
    }
}

Installation repository()
{
    Installation where;
    where.rubric = std::filesystem::path(TESTAT_REPOSITORY) / "references/rubric.json";
    return where;
}

std::string verdicts(Report const& judged)
{
    std::string all;
    for (auto const& answer : judged.at("answers"))
        all += answer.at("id").get<std::string>() + " " + answer.at("verdict").get<std::string>() + "\n";
    return all;
}

TEST(Answers, AreRefusedIfTheyAreNoObject)
{
    for (char const* bytes : {"", "{", "nonsense", "[1e999]", "{\"M\": \"\xff\"}", "{} {}", "{\"M\": 1,}"})
        EXPECT_NE(refusal(bytes).find("answers.json: this is not JSON"), std::string::npos) << bytes;
    for (char const* bytes : {"[]", "3", "null", "\"{}\""})
        EXPECT_NE(refusal(bytes).find("must be an object"), std::string::npos) << bytes;
}

TEST(Answers, AreRefusedIfTheyAreNestedDeeply)
{
    std::string const deep(400'000, '[');
    EXPECT_NE(refusal("{\"M\": " + deep).find("deep"), std::string::npos);
    EXPECT_NE(refusal("{\"M\": " + deep + std::string(400'000, ']') + "}").find("deep"), std::string::npos);
    std::string objects;
    for (int i = 0; i < 100'000; ++i)
        objects += "{\"M\":";
    EXPECT_NE(refusal(objects).find("deep"), std::string::npos);
}

TEST(Answers, MayHoldAnythingInAnyPlace)
{
    std::string const things[] = {"null",
                                  "true",
                                  "-0.0",
                                  "1e300",
                                  "\"\"",
                                  "\"\\u0000\\u001b[31m\"",
                                  "[]",
                                  "{}",
                                  "[[[]]]",
                                  "{\"A\": {\"A\": 1}}",
                                  "[null, 1, \"x\"]",
                                  "\"" + std::string(100'000, '(') + "\""};
    for (auto const& a : things)
        for (auto const& b : things) {
            Report const judged = judge(parsed("{\"transformation\": {\"M\": " + a + ", \"factors\": " + b +
                                               "}, \"barycentric\": {\"areas\": " + b + ", \"lambda\": {\"A\": " + a +
                                               "}, \"P'\": " + b + "}}"));
            EXPECT_EQ(judged.at("right"), 0);
            std::string const text = to_text(judged, "answers.json", Language::de) + to_text(judged, "x", Language::en);
            EXPECT_EQ(text.find('\x1b'), std::string::npos);
        }
    for (auto const& a : things)
        EXPECT_EQ(judge(parsed("{\"transformation\": " + a + ", \"barycentric\": " + a + "}")).at("right"), 0);
}

TEST(Answers, HaveNamesThatAreKnown)
{
    Report const judged = judge(parsed(R"({"transfomation": {}, "transformation": {"m": 1, "explanation": []},
        "barycentric": {"areas": {"F4": "1"}, "lambda": {"lambda_A": "1"}}})"));
    EXPECT_EQ(judged.at("not_read"), Report::parse(R"(["transfomation", "transformation.m", "barycentric.areas.F4",
        "barycentric.lambda.lambda_A"])"));
    EXPECT_NE(to_text(judged, "answers.json", Language::en).find("transfomation"), std::string::npos);
}

TEST(Templates, AreAnswersThatAreOpen)
{
    for (Language const language : {Language::de, Language::en}) {
        Report const judged = judge(parsed(answers_template(language, repository())));
        EXPECT_EQ(verdicts(judged),
                  "M unanswered\nfactors unanswered\nF1 unanswered\nF2 unanswered\nF3 unanswered\n"
                  "lambda_A unanswered\nlambda_B unanswered\nlambda_C unanswered\nP' unanswered\n");
        EXPECT_TRUE(judged.at("not_read").empty()) << judged.at("not_read");
    }
}

TEST(Templates, DifferInTheirExplanationsOnly)
{
    auto const bare = [](Language language) {
        Report answers = parsed(answers_template(language, repository()));
        answers.erase("explanation");
        answers["transformation"].erase("explanation");
        answers["barycentric"].erase("explanation");
        return answers;
    };
    EXPECT_EQ(bare(Language::de), bare(Language::en));
}

Report mixed()
{
    return judge(parsed(R"json({
        "transformation": {"factors": [{"translate": [1, -2, -1]}, {"rotate": {"axis": "v", "degrees": 180}}]},
        "barycentric": {"areas": {"F1": "area(P, B, C)", "F2": "2 A", "F3": ""},
                        "lambda": {"A": "F1", "B": "F2 / F"}, "P'": ""}})json"));
}

TEST(TheoryText, SaysFirstWhatIsRight)
{
    std::string const text = to_text(mixed(), "answers.json", Language::en);
    EXPECT_EQ(text.find("answers.json: 3 of 8 answers right\n"), 0u) << text;
    EXPECT_NE(text.find("    factors (calculation)   right\n"), std::string::npos) << text;
    EXPECT_NE(text.find("\nlambda_A\n  answer    F1\n  hint      It is not divided by"), std::string::npos) << text;
    EXPECT_NE(text.find("cannot be read"), std::string::npos) << text;
    EXPECT_NE(to_text(mixed(), "a.json", Language::de).find("a.json: 3 von 8 Antworten richtig"), std::string::npos);
}

TEST(TheoryText, Has80Columns)
{
    for (Language const language : {Language::de, Language::en}) {
        std::istringstream lines(to_text(mixed(), "answers.json", language));
        for (std::string line; std::getline(lines, line);)
            EXPECT_LE(columns_of(line), 80u) << line;
    }
}
}  // namespace
}  // namespace testat::theory
