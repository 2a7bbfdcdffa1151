// Every file of the corpus is graded as its first line says:
//   // verdict: {"loses": {"wrap_repeat": [0.5, 1]}, "says": {"wrap_repeat": "partial"}, "policy": [], "prints": [],
//           "remarks": [], "sanitizers": true}
// loses: points that functions lose before policy, from and to; every other function has all of its points.
// says: their words in report.json; every other function is "correct".
// policy: what of the sheet's policies applies; none if it is left out.
// prints: functions whose checks must say that they print.
// remarks: the ids of exactly the remarks that the report makes; none if it is left out.
// sanitizers: false for what shows with the system's own heap and signals only; true if it is left out.
#include "end_to_end/testat_program.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <set>

namespace testat {
namespace {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool is_sanitized = true;
#else
constexpr bool is_sanitized = false;
#endif

std::string const mark = "// verdict: ";

struct Case {
    std::filesystem::path file;
    std::string compiler;
};

std::vector<Case> all_cases()
{
    std::vector<Case> cases;
    for (char const* kind : {"correct", "wrong"})
        for (auto const& entry : std::filesystem::directory_iterator(std::filesystem::path(TESTAT_CORPUS) / kind))
            for (auto const& compiler : compilers())
                cases.push_back({entry.path(), compiler});
    for (auto const& compiler : compilers())
        cases.push_back({example_file(), compiler});
    std::stable_sort(cases.begin(), cases.end(), [](Case const& a, Case const& b) { return a.file < b.file; });
    return cases;
}

/// "wrong_repeat_abs_clang"
std::string name_of(testing::TestParamInfo<Case> const& info)
{
    std::string const compiler = info.param.compiler == "g++" ? "gcc" : "clang";
    std::string name =
        info.param.file.parent_path().filename().string() + "_" + info.param.file.stem().string() + "_" + compiler;
    std::replace_if(
        name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
    return name;
}

Json read_verdict(std::filesystem::path const& file)
{
    std::string const text = read_file(file);
    std::string const line = text.substr(0, text.find('\n'));
    std::size_t const at = line.find(mark);
    if (at == std::string::npos)
        throw std::runtime_error(file.string() + ": line 1 holds no verdict");
    return Json::parse(line.substr(at + mark.size()));
}

void expect_points(std::string const& name, Json const& function, Json const& loses)
{
    double const lost = function.at("max").get<double>() - function.at("earned").get<double>();
    Json const range = loses.value(name, Json::array({0, 0}));
    EXPECT_GE(lost, range.at(0).get<double>()) << name;
    EXPECT_LE(lost, range.at(1).get<double>()) << name;
}

void expect_word(std::string const& name, Json const& function, Json const& says)
{
    EXPECT_EQ(function.at("verdict"), says.value(name, "correct")) << name;
}

/// What the policies leave of the points.
void expect_policy(Json const& report, Json const& policy)
{
    EXPECT_EQ(report.at("policy").at("applied"), policy);
    double const without = report.at("policy").at("earned_without");
    EXPECT_EQ(report.at("points").at("earned"), policy.empty() ? without : 0.0);
}

void expect_printing_is_noted(Json const& function)
{
    for (auto const& check : function.at("checks"))
        EXPECT_NE(check.at("hint").dump().find("prints"), std::string::npos) << check.at("name");
}

void expect_remarks(Json const& report, Json const& remarks)
{
    Json found = Json::array();
    for (auto const& remark : report.value("remarks", Json::array()))
        found.push_back(remark.at("id"));
    EXPECT_EQ(found, remarks) << report.value("remarks", Json::array()).dump(2);
}

/// A verdict with a misspelt key would claim nothing.
void expect_known_names(Json const& verdict, Json const& report)
{
    static std::set<std::string> const keys{"loses", "says", "policy", "prints", "remarks", "sanitizers"};
    for (auto const& [key, value] : verdict.items())
        EXPECT_EQ(keys.count(key), 1u) << key;
    for (char const* key : {"loses", "says"}) {
        Json const functions = verdict.value(key, Json::object());
        for (auto const& [name, value] : functions.items())
            EXPECT_TRUE(report.at("functions").contains(name)) << name;
    }
}

class Corpus : public testing::TestWithParam<Case> {};

TEST_P(Corpus, IsGradedAsItsFirstLineSays)
{
    Json const verdict = read_verdict(GetParam().file);
    if (is_sanitized && !verdict.value("sanitizers", true))
        GTEST_SKIP();
    TemporaryDirectory const place;
    Graded const graded = grade_file(GetParam().file, place.path(), {"--compiler", GetParam().compiler});
    ASSERT_EQ(graded.exit_code, 0) << graded.out << graded.err;
    ASSERT_EQ(graded.report.at("status"), "graded");
    EXPECT_TRUE(graded.report.at("build").at("ok").get<bool>());

    expect_known_names(verdict, graded.report);
    for (auto const& [name, function] : graded.report.at("functions").items()) {
        expect_points(name, function, verdict.at("loses"));
        expect_word(name, function, verdict.value("says", Json::object()));
    }
    for (auto const& name : verdict.value("prints", Json::array()))
        expect_printing_is_noted(graded.report.at("functions").at(name.get<std::string>()));
    expect_policy(graded.report, verdict.value("policy", Json::array()));
    expect_remarks(graded.report, verdict.value("remarks", Json::array()));
    if (HasFailure())
        std::cout << GetParam().file.string() << " with " << GetParam().compiler << "\n"
                  << function_table_of(graded.report);
}

INSTANTIATE_TEST_SUITE_P(Submissions, Corpus, testing::ValuesIn(all_cases()), name_of);
}  // namespace
}  // namespace testat
