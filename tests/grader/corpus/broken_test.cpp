// Every file of the corpus that does not compile is graded as its first line says:
//   // verdict: {"broken": {"wrap_repeat": "return val %"}, "unofficial": [18.5, 19]}
// broken: the functions that are to blame, with a piece of the line that is named for each; 0 if there is no line.
// left_out: a piece of the line named for each other declaration that is to blame; none if it is left out.
// unofficial: points of the others, and how many there are; null if nothing can be graded.
#include "corpus/uploads.h"

#include <sstream>

namespace testat {
namespace {
std::string line_of(std::filesystem::path const& file, int number)
{
    std::istringstream lines(read_file(file));
    std::string line;
    for (int i = 0; i < number; ++i)
        std::getline(lines, line);
    return line;
}

void expect_broken(std::filesystem::path const& file, Json const& broken, Json const& expected)
{
    ASSERT_EQ(broken.size(), expected.size());
    for (auto const& [name, place] : expected.items()) {
        ASSERT_TRUE(broken.contains(name)) << name;
        EXPECT_FALSE(broken.at(name).at("message").get<std::string>().empty()) << name;
        int const line = broken.at(name).at("line");
        if (place.is_string())
            EXPECT_NE(line_of(file, line).find(place.get<std::string>()), std::string::npos) << line_of(file, line);
        else
            EXPECT_EQ(line, place) << name;
    }
}

void expect_left_out(std::filesystem::path const& file, Json const& left_out, Json const& expected)
{
    ASSERT_EQ(left_out.size(), expected.size()) << left_out;
    for (std::size_t i = 0; i < expected.size(); ++i) {
        std::string const line = line_of(file, left_out[i].at("line"));
        EXPECT_NE(line.find(expected[i].get<std::string>()), std::string::npos) << line;
    }
}

void expect_functions(Json const& functions, Json const& broken)
{
    EXPECT_EQ(functions.size() + broken.size(), 11u);
    for (auto const& [name, function] : functions.items()) {
        EXPECT_FALSE(broken.contains(name)) << name;
        EXPECT_EQ(function.at("verdict") == "correct", function.at("earned") == function.at("max")) << name;
    }
}

void expect_no_points(Json const& report)
{
    EXPECT_FALSE(report.at("build").at("ok").get<bool>());
    EXPECT_EQ(report.at("points").at("earned"), 0);
    EXPECT_EQ(report.at("policy").at("applied"), Json({"does_not_compile"}));
}

class BrokenCorpus : public testing::TestWithParam<Case> {};

TEST_P(BrokenCorpus, IsGradedAsItsFirstLineSays)
{
    Json const verdict = read_verdict(GetParam().file);
    TemporaryDirectory const place;
    Graded const graded = grade_file(GetParam().file, place.path(), {"--compiler", GetParam().compiler});
    ASSERT_EQ(graded.exit_code, 0) << graded.out << graded.err;
    expect_no_points(graded.report);
    if (verdict.at("unofficial").is_null()) {
        EXPECT_FALSE(graded.report.contains("unofficial"));
        return;
    }
    ASSERT_TRUE(graded.report.contains("unofficial")) << graded.out;
    Json const& unofficial = graded.report.at("unofficial");
    EXPECT_EQ(Json({unofficial.at("earned"), unofficial.at("max")}), verdict.at("unofficial"));
    expect_broken(GetParam().file, unofficial.at("broken"), verdict.at("broken"));
    expect_left_out(GetParam().file, unofficial.value("left_out", Json::array()),
                    verdict.value("left_out", Json::array()));
    expect_functions(unofficial.at("functions"), unofficial.at("broken"));
    if (HasFailure())
        std::cout << GetParam().file.string() << " with " << GetParam().compiler << "\n" << unofficial.dump(2) << "\n";
}

INSTANTIATE_TEST_SUITE_P(Submissions, BrokenCorpus, testing::ValuesIn(cases_in({"broken"})), name_of);
}  // namespace
}  // namespace testat
