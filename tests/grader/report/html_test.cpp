#include "example_grading.h"
#include "grey_picture.h"
#include "process/run.h"
#include "report/formats/format.h"
#include "report/formats/page.h"
#include "report/png.h"
#include "text.h"

#include <gtest/gtest.h>

namespace testat {
namespace {
constexpr char attack[] = "</pre></script><script>alert(1)</script><img src=x onerror=alert(1)>\"'{{{script}}}";

Report report_of(CheckResults const& results, Build const& build, std::string const& file = "exercise_03.cpp")
{
    Rubric const rubric = example_rubric();
    Submission submission;
    submission.file = file;
    return make_report(submission, build, results, score(results, build, rubric, false), rubric, {"1", "", 1}, {}, {});
}

Report wrong_report()
{
    CheckResults results = passed_results(example_rubric());
    for (char const* name : {"WrapClamp.Inside", "WrapClamp.Negative", "WrapRepeat.Inside"}) {
        CheckResult& result = find_result(results, name);
        result.passed = false;
        result.mismatch = Mismatch{std::string("input of ") + name, std::string("answer to ") + name, ""};
        result.detail = std::string("right for ") + name;
    }
    return report_of(results, whole_build());
}

std::string page_of(Report const& report, Language language = Language::en, std::filesystem::path const& folder = {})
{
    return to_html({{"anna", report, folder}}, language);
}

bool contains(std::string const& text, std::string const& part)
{
    return text.find(part) != std::string::npos;
}

std::size_t count(std::string const& text, std::string const& part)
{
    std::size_t n = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
        ++n;
    return n;
}

std::string between(std::string const& text, std::string const& begin, std::string const& end)
{
    std::size_t const at = text.find(begin) + begin.size();
    return text.substr(at, text.find(end, at) - at);
}

/// Every text of a report that an upload can have a part in.
void replace_texts(Report& value, std::string const& key)
{
    bool const is_ours = key == "status" || key == "verdict" || key == "visibility" || key == "task";
    if (value.is_string() && !is_ours)
        value = attack;
    else if (value.is_structured())
        for (auto& [inner, part] : value.items())
            replace_texts(part, value.is_object() ? inner : key);
}

/// "plane.png" of a report whose picture is wrong.
Report with_wrong_picture(std::string const& submitted)
{
    CheckResults results = passed_results(example_rubric());
    results.pictures.at(0).submitted->picture = grey_picture(2, 2, 0.1f);
    results.pictures.at(0).explained_by = {"wrap_clamp"};
    Report report = report_of(results, whole_build());
    report["pictures"][0]["submitted_file"] = submitted;
    return report;
}

void write_picture(std::filesystem::path const& file)
{
    std::filesystem::create_directories(file.parent_path());
    write_file(file, encode_png(grey_picture(2, 2, 0.5f), true));
}
}  // namespace

TEST(Html, AllowsItsOwnStyleAndScriptAndNothingElse)
{
    std::string const page = page_of(wrong_report());
    std::string const policy = between(page, "Content-Security-Policy\" content=\"", "\"");
    EXPECT_EQ(policy.rfind("default-src 'none'; img-src data:; style-src 'sha256-", 0), 0u) << policy;
    EXPECT_FALSE(contains(policy, "unsafe"));
    EXPECT_EQ(count(page, "<script"), 1u);
    EXPECT_EQ(count(page, "<style"), 1u);
    EXPECT_EQ(count(page, " style="), 0u) << "the policy forbids it";
    EXPECT_EQ(count(page, "http:") + count(page, "https:") + count(page, "url("), 0u);
}

TEST(Html, NamesTheHashOfItsScript)
{
    std::string const page = page_of(wrong_report());
    std::string const digits = sha256(between(page, "<script>", "</script>"));
    std::string bytes;
    for (std::size_t i = 0; i < digits.size(); i += 2)
        bytes += static_cast<char>(std::stoi(digits.substr(i, 2), nullptr, 16));
    EXPECT_TRUE(contains(page, "script-src 'sha256-" + base64(bytes) + "'"));
}

TEST(Html, TakesWhatAnUploadSaysAsText)
{
    CheckResults results = passed_results(example_rubric());
    find_result(results, "WrapClamp.Inside").passed = false;
    find_result(results, "WrapClamp.Inside").mismatch = Mismatch{"a", "b", "c"};
    results.remarks = {{"leaks", {Function::wrap_clamp}, {"de", "en"}}};
    Report report = report_of(results, mended_build());
    replace_texts(report, "");
    std::string const page = page_of(report);
    EXPECT_EQ(count(page, "<script"), 1u);
    EXPECT_EQ(count(page, "<img src=x"), 0u);
    EXPECT_GT(count(page, "&lt;script&gt;alert(1)"), 10u);
    EXPECT_GT(count(page, "{{{script}}}"), 10u) << "a text is no template";
}

TEST(Html, TakesAnErrorOfOursAsText)
{
    std::string const page = page_of(make_not_gradable({}, {"1", "", 1}, attack));
    EXPECT_EQ(count(page, "<script"), 1u);
    EXPECT_TRUE(contains(page, "&lt;script&gt;alert(1)"));
}

TEST(Html, SaysOfEveryFailedCheckWhatWasTriedWhatCameOutAndWhatToDo)
{
    std::string const page = page_of(wrong_report());
    for (char const* name : {"WrapClamp.Inside", "WrapClamp.Negative", "WrapRepeat.Inside"})
        for (char const* text : {"input of ", "answer to ", "right for ", "hint for ", "Hinweis zu "})
            EXPECT_TRUE(contains(page, std::string(text) + name)) << text << name;
}

TEST(Html, LeavesOutWhatStudentsAreNotTold)
{
    Report report = wrong_report();
    for (auto& function : report["functions"])
        for (auto& check : function["checks"])
            check["detail"] = nullptr;
    EXPECT_FALSE(contains(page_of(report), ">Expected</span></dt>"));
    EXPECT_TRUE(contains(page_of(wrong_report()), ">Expected</span></dt>"));
}

TEST(Html, BeginsWithTheLanguageAskedFor)
{
    EXPECT_TRUE(contains(page_of(wrong_report(), Language::de), "id=\"lang-de\" value=\"de\" checked"));
    EXPECT_TRUE(contains(page_of(wrong_report(), Language::en), "id=\"lang-en\" value=\"en\" checked"));
    EXPECT_TRUE(contains(page_of(wrong_report(), Language::de), "<html lang=\"de\">"));
}

TEST(Html, ShowsTheCompilersMessageBeneathItsLine)
{
    std::string const page = page_of(report_of(passed_results(example_rubric()), mended_build()));
    EXPECT_TRUE(contains(between(page, "id=\"f-wrap_clamp\"", "</article>"), "was not declared"));
    EXPECT_TRUE(contains(page, "data-n=\"2\""));
}

TEST(Html, QuotesANameForTheShell)
{
    std::string const page = page_of(report_of(passed_results(example_rubric()), whole_build(), "a b;$(c)'.cpp"));
    EXPECT_TRUE(contains(page, "./testat grade &apos;a b;$(c)&apos;\\&apos;&apos;.cpp&apos;"));
}

TEST(Html, HoldsItsPictures)
{
    TemporaryDirectory const place;
    Report const report = with_wrong_picture("pictures/mine.png");
    write_picture(place.path() / "pictures" / "mine.png");
    write_picture(place.path() / "pictures" / "clamped.expected.png");
    std::string const page = page_of(report, Language::en, place.path());
    EXPECT_EQ(count(page, "src=\"data:image/png;base64,iVBOR"), 2u);
    EXPECT_TRUE(contains(page, "in-full"));
}

TEST(Html, DoesWithoutPicturesThatAreNotThereOrNone)
{
    TemporaryDirectory const place;
    write_picture(place.path() / "outside.png");
    std::filesystem::create_directories(place.path() / "report" / "pictures");
    write_file(place.path() / "report" / "pictures" / "text.png", "secret");
    for (char const* file : {"pictures/none.png", "../outside.png", "pictures/text.png", ""})
        EXPECT_EQ(count(page_of(with_wrong_picture(file), Language::en, place.path() / "report"), "src=\"data:"), 0u)
            << file;
}

TEST(Page, WantsWordsInBothLanguages)
{
    EXPECT_THROW(Page("<p>[[nur deutsch]]</p>", "", ""), std::logic_error);
    EXPECT_EQ(Page("[[ja|yes]]", "", "").render(Report::object()),
              "<span lang=\"de\">ja</span><span lang=\"en\">yes</span>");
}

TEST(Page, EscapesNamesInAddresses)
{
    EXPECT_EQ(url_part("a_1 \"ü/.."), "a_1%20%22%C3%BC%2F%2E%2E");
}

TEST(Page, EncodesBytes)
{
    EXPECT_EQ(base64("foob"), "Zm9vYg==");
    EXPECT_EQ(base64(""), "");
}
}  // namespace testat
