// `testat grade` on files that are what they should be.
#include "end_to_end/testat_program.h"

#include <gtest/gtest.h>

namespace testat {
namespace {
Graded grade(std::filesystem::path const& upload, std::vector<std::string> const& arguments = {})
{
    TemporaryDirectory const place;
    return grade_file(upload, place.path() / "out", arguments);
}

double earned(Graded const& graded)
{
    return graded.report.at("points").at("earned");
}

/// The report without the two parts that time makes.
std::string without_times(Json report)
{
    report.erase("timing");
    report.erase("run_time");
    return report.dump();
}

std::vector<std::string> files_below(std::filesystem::path const& directory)
{
    std::vector<std::string> files;
    for (auto const& entry : std::filesystem::recursive_directory_iterator(directory))
        if (entry.is_regular_file())
            files.push_back(entry.path().filename().string());
    return files;
}

class Reference : public testing::TestWithParam<std::string> {};

TEST_P(Reference, EarnsAllPoints)
{
    Graded const graded = grade(reference_file(), {"--compiler", GetParam()});
    EXPECT_EQ(graded.exit_code, 0) << graded.err;
    EXPECT_EQ(earned(graded), 20) << function_table_of(graded.report);
    EXPECT_TRUE(graded.report.at("points").at("passed_60_percent").get<bool>());
    EXPECT_NE(graded.out.find("20.00 of 20.00 points"), std::string::npos) << graded.out;
}

TEST_P(Reference, HasNoRemarks)
{
    Graded const graded = grade(reference_file(), {"--compiler", GetParam()});
    for (auto const& [name, function] : graded.report.at("functions").items())
        for (auto const& check : function.at("checks")) {
            EXPECT_TRUE(check.at("hint").is_null()) << check;
            EXPECT_TRUE(check.at("worst_input").is_null()) << check;
        }
    for (auto const& picture : graded.report.at("pictures"))
        EXPECT_FALSE(picture.contains("explained_by")) << picture;
}

std::string compiler_name(testing::TestParamInfo<std::string> const& info)
{
    return info.param == "g++" ? "gcc" : "clang";
}
INSTANTIATE_TEST_SUITE_P(Compilers, Reference, testing::ValuesIn(compilers()), compiler_name);

TEST(Template, EarnsNothing)
{
    Graded const graded = grade(template_file());
    EXPECT_EQ(graded.exit_code, 0) << graded.err;
    EXPECT_EQ(earned(graded), 0) << function_table_of(graded.report);
    EXPECT_EQ(graded.report.at("policy").at("earned_without"), 0) << function_table_of(graded.report);
    EXPECT_TRUE(graded.report.at("build").at("ok").get<bool>());
}

TEST(Grade, GivesTheSameBytesTwice)
{
    Graded const first = grade(example_file());
    Graded const second = grade(example_file());
    EXPECT_EQ(without_times(first.report), without_times(second.report));
}

/// Every worst input of the checks that fail.
std::string worst_inputs(Graded const& graded)
{
    std::string inputs;
    for (auto const& [name, function] : graded.report.at("functions").items())
        for (auto const& check : function.at("checks"))
            inputs += check.at("worst_input").dump() + "\n";
    return inputs;
}

class Seed : public testing::TestWithParam<std::filesystem::path> {};

TEST_P(Seed, ChangesTheTestSetAndNoPoints)
{
    Graded const usual = grade(GetParam());
    Graded const seventh = grade(GetParam(), {"--seed", "7"});
    EXPECT_NE(usual.report.at("test_set").at("sha256"), seventh.report.at("test_set").at("sha256"));
    EXPECT_EQ(seventh.report.at("test_set").at("seed"), 7);
    for (auto const& [name, function] : usual.report.at("functions").items())
        EXPECT_EQ(function.at("earned"), seventh.report.at("functions").at(name).at("earned")) << name;
}

INSTANTIATE_TEST_SUITE_P(Files, Seed, testing::Values(reference_file(), template_file(), example_file()),
                         [](auto const& p) { return p.param.parent_path().filename().string(); });

TEST(Seed, ChangesTheInputs)
{
    EXPECT_NE(worst_inputs(grade(example_file())), worst_inputs(grade(example_file(), {"--seed", "7"})));
}

TEST(Tasks, LimitTheMaximum)
{
    Graded const graded = grade(reference_file(), {"--tasks", "a,c"});
    EXPECT_EQ(graded.report.at("points").at("max"), 6);
    EXPECT_EQ(earned(graded), 6);
    EXPECT_EQ(graded.report.at("tasks").size(), 2u);
    EXPECT_EQ(graded.report.at("functions").size(), 2u);
}

TEST(NoSandbox, IsToldByTheReport)
{
    TemporaryDirectory const place;
    for (bool caged : {true, false}) {
        auto const arguments = caged ? std::vector<std::string>{} : std::vector<std::string>{"--no-sandbox"};
        Graded const graded = grade_file(reference_file(), place.path(), arguments);
        EXPECT_EQ(graded.report.at("sandbox"), caged);
        EXPECT_EQ(graded.report.at("points").at("earned"), 20);
        EXPECT_EQ(graded.out.find("Run without a cage (--no-sandbox)") == std::string::npos, caged) << graded.out;
    }
}

TEST(Lenient, LeavesThePoliciesOut)
{
    std::string const crashes = patched_reference(
        "int ImageTexture::wrap_repeat(int val, int size)\n"
        "{\n    return val % size;\n}\n");
    Graded const strict = grade_text(crashes);
    EXPECT_EQ(strict.report.at("policy").at("applied"), Json({"crashes"}));
    EXPECT_EQ(earned(strict), 0);
    Graded const lenient = grade_text(crashes, {"--lenient"});
    EXPECT_EQ(lenient.report.at("policy").at("applied"), Json::array());
    EXPECT_EQ(earned(lenient), 19.5);
    EXPECT_EQ(strict.report.at("policy").at("earned_without"), 19.5);
}

TEST(Mistake, CostsOnlyItsFunction)
{
    Graded const graded =
        grade_text(patched_reference("int ImageTexture::wrap_repeat(int val, int size)\n"
                                     "{\n    return std::abs(val % size);\n}\n"));
    for (auto const& [name, function] : graded.report.at("functions").items())
        EXPECT_EQ(function.at("earned") == function.at("max"), name != "wrap_repeat") << name;
    for (auto const& picture : graded.report.at("pictures"))
        if (picture.contains("explained_by")) {
            EXPECT_EQ(picture.at("explained_by"), Json({"wrap_repeat"})) << picture;
        }
}

/// A wrong wrap_repeat shows in the pictures of others, as submitted, but is not held against them.
TEST(Mistake, IsNamedAtThePicturesItSpoils)
{
    Graded const graded =
        grade_text(patched_reference("int ImageTexture::wrap_repeat(int val, int size)\n"
                                     "{\n    return std::abs(val % size);\n}\n"));
    for (auto const& picture : graded.report.at("pictures"))
        if (picture.at("name") == "plane_after_c" || picture.at("name") == "plane_after_b_repeat") {
            EXPECT_EQ(picture.value("explained_by", Json()), Json({"wrap_repeat"})) << picture;
            EXPECT_EQ(picture.at("score") == 1, picture.at("name") == "plane_after_c") << picture;
        }
}

TEST(Language, IsGermanOnRequest)
{
    Graded const graded = grade(example_file(), {"--lang", "de"});
    EXPECT_NE(graded.out.find("Punkten"), std::string::npos) << graded.out;
    EXPECT_NE(graded.out.find("Aufgabe a) Nächstes Texel"), std::string::npos) << graded.out;
    EXPECT_EQ(graded.out.find("points"), std::string::npos) << graded.out;
}

TEST(Report, FitsItsSchemaAndIsRenderedAgain)
{
    TemporaryDirectory const place;
    grade_file(example_file(), place.path());
    Outcome const rendered = run_testat({"render", (place.path() / "report.json").string(), "--format", "json"});
    EXPECT_EQ(rendered.exit_code, 0) << rendered.err;
    EXPECT_EQ(rendered.out, read_file(place.path() / "report.json"));
}

TEST(Report, NamesFilesThatExist)
{
    TemporaryDirectory const place;
    Graded const graded = grade_file(example_file(), place.path());
    for (auto const& picture : graded.report.at("pictures"))
        for (char const* key : {"isolated_file", "submitted_file", "expected_file", "difference_file"}) {
            if (picture.at(key).is_null())
                continue;
            EXPECT_TRUE(std::filesystem::is_regular_file(place.path() / picture.at(key).get<std::string>())) << key;
        }
}

TEST(Report, IsReplacedAsAWhole)
{
    TemporaryDirectory const place;
    grade_file(example_file(), place.path());
    Graded const again = grade_file(reference_file(), place.path());
    EXPECT_EQ(earned(again), 20);
    for (auto const& file : files_below(place.path()))
        EXPECT_EQ(file.find(".part"), std::string::npos) << file;
}

/// A picture that was made by the file before would be taken for one of this file.
TEST(Report, LeavesNoPicturesOfTheFileBefore)
{
    TemporaryDirectory const place;
    grade_file(reference_file(), place.path());
    Graded const again = grade_file(reference_file(), place.path(), {"--tasks", "a"});
    for (auto const& file : files_below(place.path() / "pictures"))
        EXPECT_NE(file.find("_after_a_zero."), std::string::npos) << file;
}

TEST(Timing, IsPrintedOnRequest)
{
    Graded const with = grade(example_file(), {"--timing"});
    Graded const without = grade(example_file());
    for (char const* stage : {"\ncompile ", "\nobserve: unit checks ", "\ncheck ", "\ntotal "}) {
        EXPECT_NE(with.out.find(stage), std::string::npos) << stage << with.out;
        EXPECT_EQ(without.out.find(stage), std::string::npos) << stage << without.out;
    }
}

TEST(Report, GoesToAFolderNamedAfterTheFileUnlessToldOtherwise)
{
    TemporaryDirectory const place;
    auto const here = std::filesystem::current_path();
    std::filesystem::current_path(place.path());
    run_testat({"grade", reference_file().string(), "--tasks", "a"});
    std::filesystem::current_path(here);
    EXPECT_TRUE(std::filesystem::exists(place.path() / "testat-out/exercise_03/report.json"));
}
}  // namespace
}  // namespace testat
