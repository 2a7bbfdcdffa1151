// `testat render`: reports once more.
#include "end_to_end/testat_program.h"

#include <gtest/gtest.h>

namespace testat {
namespace {
class Rendered : public testing::Test {
protected:
    Rendered() : graded_(grade_file(example_file(), place_.path())) {}

    Outcome render(std::vector<std::string> const& arguments) const
    {
        std::vector<std::string> all{"render", report().string()};
        all.insert(all.end(), arguments.begin(), arguments.end());
        return run_testat(all, {"LC_ALL=C.UTF-8"});
    }
    std::filesystem::path report() const { return place_.path() / "report.json"; }

    TemporaryDirectory place_;
    Graded graded_;
};

TEST_F(Rendered, IsWhatGradeHasPrinted)
{
    Outcome const text = render({"--format", "text"});
    EXPECT_EQ(text.exit_code, 0) << text.err;
    EXPECT_EQ(graded_.out.rfind(text.out, 0), 0u) << text.out << graded_.out;
}

TEST_F(Rendered, IsTheSameJson)
{
    EXPECT_EQ(render({"--format", "json"}).out, read_file(report()));
}

TEST_F(Rendered, IsAPageWithItsPictures)
{
    std::string const page = render({"--format", "html", "--lang", "de"}).out;
    EXPECT_EQ(page.rfind("<!doctype html>", 0), 0u);
    EXPECT_NE(page.find("abs(val % size)"), std::string::npos);
    EXPECT_NE(page.find("picture in-full"), std::string::npos);
    EXPECT_GT(page.size(), 500'000u);
    EXPECT_LT(page.size(), 8'000'000u);
}

TEST_F(Rendered, MayBeSeveral)
{
    Outcome const one = render({});
    Outcome const two = render({report().string()});
    EXPECT_EQ(two.out, one.out + one.out);
}

TEST_F(Rendered, IsGermanOnRequest)
{
    EXPECT_NE(render({"--lang", "de"}).out.find("Punkten"), std::string::npos);
    EXPECT_NE(run_testat({"render", report().string()}, {"LC_ALL=de_DE.UTF-8"}).out.find("Punkten"), std::string::npos);
}

TEST(Page, ShowsScriptsOfAnUploadAsText)
{
    TemporaryDirectory const place;
    auto const attacks = example_file().parent_path().parent_path() / "attacks";
    std::string const attack = read_file(attacks / "writes_scripts_into_the_report.cpp");
    auto const file = place.path() / "a<script>owned(5)<\\script>\".cpp";
    write_file(file, reference_text() + attack);
    Outcome const graded =
        run_testat({"grade", file.string(), "--out", (place.path() / "out").string(), "--format", "html"});
    ASSERT_EQ(graded.exit_code, 0) << graded.err;
    std::string const page = read_file(place.path() / "out" / "report.html");
    EXPECT_EQ(page.find("<script"), page.rfind("<script")) << "ours";
    EXPECT_NE(page.find("&lt;script&gt;owned(1)"), std::string::npos);
    EXPECT_NE(page.find("a&lt;script&gt;owned(5)"), std::string::npos);
}

class Garbage : public testing::TestWithParam<std::string> {};

TEST_P(Garbage, IsNoReport)
{
    TemporaryDirectory const place;
    write_file(place.path() / "report.json", GetParam());
    Outcome const ran = run_testat({"render", (place.path() / "report.json").string()});
    EXPECT_EQ(ran.exit_code, 2) << ran.out;
    EXPECT_NE(ran.err.find("report.json"), std::string::npos) << ran.err;
    EXPECT_TRUE(ran.out.empty()) << ran.out;
}

INSTANTIATE_TEST_SUITE_P(Render, Garbage,
                         testing::Values("", "no json", "{", "[]", "null", "{}", "{\"status\": \"graded\"}",
                                         "{\"schema_version\": 2, \"status\": \"graded\"}", "\xff\xfe{",
                                         std::string(100'000, '[')));

TEST(Render, RefusesADirectory)
{
    TemporaryDirectory const place;
    EXPECT_EQ(run_testat({"render", place.path().string()}).exit_code, 2);
}
}  // namespace
}  // namespace testat
