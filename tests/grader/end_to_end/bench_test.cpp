// `testat bench`
#include "end_to_end/testat_program.h"

#include <gtest/gtest.h>

namespace testat {
namespace {
struct Benched : Outcome {
    Json document;  ///< null if none was written
    std::string svg;
};

Benched bench(std::vector<std::string> const& arguments)
{
    TemporaryDirectory const place;
    std::vector<std::string> all{"bench", "--quick", "--out", place.path().string()};
    all.insert(all.end(), arguments.begin(), arguments.end());
    Benched benched{run_testat(all, {"LC_ALL=C.UTF-8"}), nullptr, ""};
    if (std::filesystem::exists(place.path() / "bench.json")) {
        benched.document = Json::parse(read_file(place.path() / "bench.json"));
        benched.svg = read_file(place.path() / "bench.svg");
    }
    return benched;
}

Json const& score(Benched const& benched, char const* filter)
{
    return benched.document.at("summary").at("all").at("filters").at(filter);
}

TEST(Bench, FindsTheReferenceAsAccurateInTheCageAsOutside)
{
    Benched const benched = bench({reference_file().string()});
    EXPECT_EQ(benched.exit_code, 0) << benched.err;
    EXPECT_EQ(benched.document.at("cases").size(), 30u);
    for (char const* name : {"nearest", "bilinear", "trilinear"})
        for (char const* place : {"upload_", "caged_"}) {
            Json const& caged = score(benched, (std::string(place) + name).c_str());
            Json const& outside = score(benched, (std::string("reference_") + name).c_str());
            EXPECT_EQ(caged.at("rmse"), outside.at("rmse")) << place << name;
            EXPECT_GT(caged.at("ns"), 0) << place << name;
        }
    EXPECT_NE(benched.svg.find("</svg>"), std::string::npos);
}

/// What crashes has no score; the rest goes on.
TEST(Bench, SurvivesWhatAnUploadDoes)
{
    TemporaryDirectory const place;
    write_file(place.path() / "exercise_03.cpp",
               patched_reference("glm::vec4 ImageTexture::evaluate_nearest(int, glm::vec2 const&) const\n"
                                 "{\n    std::abort();\n}\n"));
    Benched const benched = bench({(place.path() / "exercise_03.cpp").string()});
    EXPECT_EQ(benched.exit_code, 0) << benched.err;
    EXPECT_FALSE(benched.document.at("summary").at("all").at("filters").contains("upload_nearest"));
    EXPECT_GT(score(benched, "upload_trilinear").at("ns"), 0);
}

TEST(Bench, SaysWhatDoesNotCompileAndMeasuresOurs)
{
    TemporaryDirectory const place;
    write_file(place.path() / "exercise_03.cpp", "int main() { return nonsense; }\n");
    Benched const benched = bench({(place.path() / "exercise_03.cpp").string()});
    EXPECT_EQ(benched.exit_code, 0) << benched.err;
    EXPECT_NE(benched.out.find("nonsense"), std::string::npos) << benched.out;
    EXPECT_GT(score(benched, "ewa").at("ns"), 0);
}

TEST(Bench, RefusesWrongUsage)
{
    EXPECT_EQ(bench({"/nonexistent/exercise_03.cpp"}).exit_code, 2);
    EXPECT_EQ(bench({"--lang", "fr"}).exit_code, 2);
    EXPECT_EQ(run_testat({"bench", "--out", "/proc/none"}).exit_code, 2);
}
}  // namespace
}  // namespace testat
