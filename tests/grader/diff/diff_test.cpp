#include "diff/diff.h"

#include "example_grading.h"
#include "process/run.h"

#include <gtest/gtest.h>

namespace testat {
namespace {
Report report_of(CheckResults const& results, Timing const& timing = {})
{
    Rubric const rubric = example_rubric();
    Build const build = whole_build();
    return make_report({}, build, results, score(results, build, rubric, false), rubric, {"1", "", 1}, timing, {});
}

Bitmap const grey{2, 1, {9, 9, 9, 255, 9, 9, 9, 255}};
}  // namespace

TEST(DiffReports, LooksAwayFromTimes)
{
    CheckResults const results = passed_results(example_rubric());
    EXPECT_TRUE(diff_reports(report_of(results, {1, 2, 3, 4}), report_of(results, {5, 6, 7, 8}), Language::en).same);
}

TEST(DiffReports, TellsPointsVerdictsAndChecks)
{
    CheckResults const right = passed_results(example_rubric());
    CheckResults wrong = right;
    find_result(wrong, "WrapClamp.Negative").passed = false;
    Difference const difference = diff_reports(report_of(right), report_of(wrong), Language::en);
    EXPECT_FALSE(difference.same);
    EXPECT_NE(difference.text.find("1.00 correct -> 0.25 partial"), std::string::npos) << difference.text;
    EXPECT_NE(difference.text.find("passes -> fails"), std::string::npos) << difference.text;
    EXPECT_EQ(difference.text.find("wrap_repeat"), std::string::npos) << difference.text;
}

TEST(DiffReports, TellsThatOneIsNotGradable)
{
    Report const right = report_of(passed_results(example_rubric()));
    Difference const difference = diff_reports(right, make_not_gradable({}, {"1", "", 1}, "no compiler"), Language::de);
    EXPECT_FALSE(difference.same);
    EXPECT_NE(difference.text.find("graded -> not_gradable"), std::string::npos) << difference.text;
}

TEST(DiffPictures, CountsPixelsAndTellsTheLargestStep)
{
    Bitmap other = grey;
    other.rgba[4] = 12;
    EXPECT_TRUE(diff_pictures(grey, grey, Language::en).same);
    Difference const difference = diff_pictures(grey, other, Language::en);
    EXPECT_FALSE(difference.same);
    EXPECT_NE(difference.text.find("1 of 2 pixels differ, by 3 of 255"), std::string::npos) << difference.text;
}

TEST(DiffPictures, TellsOtherSizes)
{
    EXPECT_FALSE(diff_pictures(grey, {1, 2, grey.rgba}, Language::en).same);
}

TEST(Diff, ReadsPicturesAndRefusesWhatIsNeither)
{
    TemporaryDirectory const place;
    auto const png = place.path() / "a.png", text = place.path() / "b.txt", broken = place.path() / "c.png";
    std::string const bytes = encode_png({1, 1, {0, 0.5f, 1}}, false);
    write_file(png, bytes);
    write_file(text, "no report");
    write_file(broken, bytes.substr(0, bytes.size() / 2));
    EXPECT_TRUE(diff(png, png, Language::en).same);
    EXPECT_THROW(diff(png, text, Language::en), std::invalid_argument);
    EXPECT_THROW(diff(text, text, Language::en), std::invalid_argument);
    EXPECT_THROW(diff(png, broken, Language::en), std::invalid_argument);
    EXPECT_THROW(diff(png, place.path() / "none", Language::en), std::invalid_argument);
}
}  // namespace testat
