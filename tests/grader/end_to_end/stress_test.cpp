// `testat stress`
#include "end_to_end/testat_program.h"

#include <gtest/gtest.h>

namespace testat {
namespace {
struct Stressed : Outcome {
    Json document;  ///< null if none was written
    std::string svg;
};

Stressed stress_file(std::filesystem::path const& file, std::vector<std::string> const& arguments = {})
{
    TemporaryDirectory const place;
    std::vector<std::string> all{"stress", file.string(), "--out", place.path().string(), "--questions", "3000"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    Stressed stressed{run_testat(all, {"LC_ALL=C.UTF-8"}), nullptr, ""};
    if (std::filesystem::exists(place.path() / "stress.json")) {
        stressed.document = Json::parse(read_file(place.path() / "stress.json"));
        stressed.svg = read_file(place.path() / "stress.svg");
    }
    return stressed;
}

Stressed stress_text(std::string const& text, std::vector<std::string> const& arguments = {})
{
    TemporaryDirectory const place;
    write_file(place.path() / "exercise_03.cpp", text);
    return stress_file(place.path() / "exercise_03.cpp", arguments);
}

/// The reference but for evaluate_nearest, which returns red after this.
Stressed stress_nearest(std::string const& statements)
{
    return stress_text(
        patched_reference("glm::vec4 ImageTexture::evaluate_nearest(int level, glm::vec2 const& uv) const\n{\n" +
                          statements + "    return get_texel(level, int(uv.x), 0);\n}\n"));
}

Json const& nearest(Stressed const& stressed)
{
    return stressed.document.at("functions").at("evaluate_nearest");
}

TEST(Stress, FindsTheReferenceInsideItsBounds)
{
    Stressed const stressed = stress_file(reference_file());
    EXPECT_EQ(stressed.exit_code, 0) << stressed.err;
    EXPECT_EQ(stressed.document.at("functions").size(), 11u);
    for (auto const& [name, function] : stressed.document.at("functions").items()) {
        EXPECT_LT(function.at("max").get<double>(), 1) << name << function.at("worst_input");
        for (char const* key : {"nan", "infinite", "crashed", "exceptions", "timed_out", "not_answered", "wrong"})
            EXPECT_EQ(function.at(key), 0) << name << " " << key;
        for (char const* key : {"crashed", "exceptions", "timed_out", "not_answered"})
            EXPECT_EQ(function.at("outside").at(key), 0) << name << " " << key;
    }
    EXPECT_NE(stressed.svg.find("</svg>"), std::string::npos);
}

TEST(Stress, GivesTheSameBytesTwice)
{
    Stressed const first = stress_file(reference_file());
    Stressed const second = stress_file(reference_file());
    EXPECT_EQ(first.document, second.document);
    EXPECT_EQ(first.svg, second.svg);
    EXPECT_NE(first.document, stress_file(reference_file(), {"--seed", "2"}).document);
}

TEST(Stress, AsksNothingOutsideTheContractOnRequest)
{
    Stressed const stressed = stress_file(reference_file(), {"--contract-only"});
    for (auto const& [name, function] : stressed.document.at("functions").items()) {
        EXPECT_EQ(function.at("outside").at("asked"), 0) << name;
        EXPECT_EQ(function.at("asked"), function.at("in_contract")) << name;
    }
}

TEST(Stress, BlamesOnlyTheFunctionThatIsWrong)
{
    Stressed const stressed = stress_nearest("");
    for (auto const& [name, function] : stressed.document.at("functions").items())
        EXPECT_EQ(function.at("wrong").get<int>() > 0, name == "evaluate_nearest") << name;
}

TEST(Stress, CountsEveryCrashAndGoesOnBehindIt)
{
    Stressed const stressed = stress_nearest("    if (uv.x == 1.f && uv.y < 0) std::abort();\n");
    EXPECT_EQ(stressed.exit_code, 0) << stressed.err;
    EXPECT_GT(nearest(stressed).at("crashed"), 10);
    EXPECT_EQ(nearest(stressed).at("not_answered"), 0);
    EXPECT_EQ(nearest(stressed).at("judged").get<int>() + nearest(stressed).at("crashed").get<int>(), 3000);
    EXPECT_EQ(stressed.document.at("functions").at("wrap_clamp").at("crashed"), 0);
}

TEST(Stress, SaysHowManyQuestionsItLeftOut)
{
    Stressed const stressed = stress_nearest("    throw level;\n");
    int const exceptions = nearest(stressed).at("exceptions");
    EXPECT_GT(exceptions, 100);
    EXPECT_EQ(nearest(stressed).at("not_answered").get<int>() + exceptions, 3000);
    EXPECT_NE(stressed.out.find("left out"), std::string::npos) << stressed.out;
}

TEST(Stress, StopsAskingWhatHangs)
{
    Stressed const stressed = stress_nearest("    for (volatile int i = 0;; i = 1 - i) {}\n");
    EXPECT_EQ(stressed.exit_code, 0) << stressed.err;
    EXPECT_GE(nearest(stressed).at("timed_out"), 1);
    EXPECT_GT(nearest(stressed).at("not_answered"), 2900);
}

TEST(Stress, CountsNanInsideTheContract)
{
    Stressed const stressed = stress_nearest("    if (uv.x < 0) return glm::vec4(std::nanf(\"\"));\n");
    EXPECT_GT(nearest(stressed).at("nan"), 100);
    EXPECT_TRUE(nearest(stressed).at("max").is_null());
}

TEST(Stress, SaysWhatDoesNotCompile)
{
    Stressed const stressed = stress_text("int main() { return nonsense; }\n");
    EXPECT_EQ(stressed.exit_code, 0) << stressed.err;
    EXPECT_FALSE(stressed.document.at("build").at("ok").get<bool>());
    EXPECT_TRUE(stressed.document.at("functions").empty());
    EXPECT_NE(stressed.out.find("nonsense"), std::string::npos) << stressed.out;
}

TEST(Stress, AsksNothingOfTheTemplate)
{
    Stressed const stressed = stress_file(template_file());
    for (auto const& [name, function] : stressed.document.at("functions").items()) {
        EXPECT_FALSE(function.at("written").get<bool>()) << name;
        EXPECT_EQ(function.at("asked"), 0) << name;
    }
}

TEST(Stress, IsGermanOnRequest)
{
    Stressed const stressed = stress_file(reference_file(), {"--lang", "de"});
    EXPECT_NE(stressed.out.find("größter"), std::string::npos) << stressed.out;
    EXPECT_NE(stressed.svg.find("größter"), std::string::npos);
}

TEST(Stress, RefusesWrongUsage)
{
    EXPECT_EQ(stress_file("/nonexistent/exercise_03.cpp").exit_code, 2);
    EXPECT_EQ(stress_file(reference_file(), {"--questions", "0"}).exit_code, 2);
    EXPECT_EQ(stress_file(reference_file(), {"--lang", "fr"}).exit_code, 2);
    EXPECT_EQ(run_testat({"stress", reference_file().string(), "--out", "/proc/none"}).exit_code, 2);
}

TEST(Stress, GoesToAFolderNamedAfterTheFileUnlessToldOtherwise)
{
    TemporaryDirectory const place;
    auto const here = std::filesystem::current_path();
    std::filesystem::current_path(place.path());
    run_testat({"stress", reference_file().string(), "--questions", "10"});
    std::filesystem::current_path(here);
    EXPECT_TRUE(std::filesystem::exists(place.path() / "testat-out/exercise_03-stress/stress.json"));
}
}  // namespace
}  // namespace testat
