// `testat theory` as its users see it.
#include "end_to_end/testat_program.h"

#include <gtest/gtest.h>

namespace testat {
namespace {
TEST(TheoryCommand, ChecksTheTemplateThatItWrites)
{
    TemporaryDirectory const place;
    std::string const file = (place.path() / "answers.json").string();
    EXPECT_EQ(run_testat({"theory", "--template", "de", "--out", file}).exit_code, 0);
    Outcome const ran = run_testat({"theory", file, "--lang", "de"});
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_EQ(ran.out.find("answers.json: 0 von 9 Antworten richtig"), 0u) << ran.out;
    EXPECT_EQ(run_testat({"theory", "--template", "de"}).out, read_file(file));
}

TEST(TheoryCommand, OverwritesNothingUnasked)
{
    TemporaryDirectory const place;
    std::string const file = (place.path() / "answers.json").string();
    write_file(file, "mine");
    Outcome const refused = run_testat({"theory", "--template", "en", "--out", file});
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_NE(refused.err.find("--overwrite"), std::string::npos) << refused.err;
    EXPECT_EQ(read_file(file), "mine");
    EXPECT_EQ(run_testat({"theory", "--template", "en", "--out", file, "--overwrite"}).exit_code, 0);
    EXPECT_NE(read_file(file), "mine");
}

TEST(TheoryCommand, EndsWith0WhateverTheAnswers)
{
    TemporaryDirectory const place;
    std::string const file = (place.path() / "answers.json").string();
    write_file(file, R"({"transformation": {"M": [[1, 2], [3, 4]]}})");
    Outcome const ran = run_testat({"theory", file, "--lang", "en"});
    EXPECT_EQ(ran.exit_code, 0);
    EXPECT_NE(ran.out.find("four rows"), std::string::npos) << ran.out;
    Json const judged = Json::parse(run_testat({"theory", file, "--format", "json"}).out);
    EXPECT_EQ(judged.at("right"), 0);
    EXPECT_EQ(judged.at("answers").at(0).at("verdict"), "unreadable");
}

TEST(TheoryCommand, RefusesWhatIsNoFileOfAnswers)
{
    TemporaryDirectory const place;
    std::string const file = (place.path() / "answers.json").string();
    EXPECT_EQ(run_testat({"theory", file}).exit_code, 2);
    EXPECT_EQ(run_testat({"theory", place.path().string()}).exit_code, 2);
    write_file(file, "{\"M\": ");
    Outcome const ran = run_testat({"theory", file});
    EXPECT_EQ(ran.exit_code, 2);
    EXPECT_NE(ran.err.find("answers.json: this is not JSON"), std::string::npos) << ran.err;
    write_file(file, std::string(2 << 20, ' '));
    EXPECT_NE(run_testat({"theory", file}).err.find("too large"), std::string::npos);
}

TEST(TheoryCommand, RefusesWrongUsage)
{
    for (std::vector<std::string> const& arguments : {std::vector<std::string>{"theory"},
                                                      {"theory", "a.json", "--template", "de"},
                                                      {"theory", "--template", "fr"},
                                                      {"theory", "a.json", "--out", "b.json"},
                                                      {"theory", "a.json", "--lang", "fr"}})
        EXPECT_EQ(run_testat(arguments).exit_code, 2) << arguments.size();
}
}  // namespace
}  // namespace testat
