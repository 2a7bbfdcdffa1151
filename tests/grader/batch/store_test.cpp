#include "batch/store.h"

#include <gtest/gtest.h>

namespace testat {
namespace {
GradingBasis const basis{"programs", "rubric", "compiler", 1, false};

void write_result(std::filesystem::path const& folder, std::string const& text)
{
    std::filesystem::create_directories(folder);
    write_file(folder / "report.json", text);
}
}  // namespace

TEST(Store, FindsWhatWasKept)
{
    TemporaryDirectory const place;
    Store const store(place.path() / "store");
    EXPECT_FALSE(store.find("a"));
    write_result(store.begin("a"), R"({"status": "graded"})");
    EXPECT_FALSE(store.find("a"));
    store.keep("a");
    EXPECT_TRUE(store.find("a"));
}

TEST(Store, GradesAgainWhatIsDamagedOrWasNotGradable)
{
    TemporaryDirectory const place;
    Store const store(place.path() / "store");
    for (char const* text : {R"({"status": "not_gradable"})", "{", "", "[]"}) {
        write_result(store.begin("a"), text);
        store.keep("a");
        EXPECT_FALSE(store.find("a")) << text;
    }
}

TEST(Store, ForgetsWhatWasUnderWayWhenItWasKilled)
{
    TemporaryDirectory const place;
    {
        Store const store(place.path() / "store");
        write_result(store.begin("a"), R"({"status": "graded"})");
    }
    Store const store(place.path() / "store");
    EXPECT_FALSE(store.find("a"));
    EXPECT_TRUE(std::filesystem::is_empty(place.path() / "store/work"));
}

TEST(Store, IsForOneBatchAtATime)
{
    TemporaryDirectory const place;
    Store const store(place.path() / "store");
    EXPECT_THROW(Store(place.path() / "store"), std::runtime_error);
}

TEST(Store, KeysDependOnFileAndBasis)
{
    TemporaryDirectory const place;
    auto const file = place.path() / "a.cpp", copy = place.path() / "b.cpp", other = place.path() / "c.cpp";
    write_file(file, "int a;");
    write_file(copy, "int a;");
    write_file(other, "int b;");
    GradingBasis lenient = basis;
    lenient.lenient = true;
    EXPECT_EQ(Store::key(file, basis), Store::key(copy, basis));
    EXPECT_NE(Store::key(file, basis), Store::key(other, basis));
    EXPECT_NE(Store::key(file, basis), Store::key(file, lenient));
}

TEST(GradingBasis, NamesEveryPart)
{
    std::string const key = basis.key();
    for (auto const& other : {GradingBasis{"x", "rubric", "compiler", 1, false},
                              {"programs", "x", "compiler", 1, false},
                              {"programs", "rubric", "x", 1, false},
                              {"programs", "rubric", "compiler", 2, false},
                              {"programs", "rubric", "compiler", 1, true}})
        EXPECT_NE(other.key(), key);
}

TEST(GradingBasis, IsTheSameTwice)
{
    EXPECT_EQ(current_basis("g++", 1, false).key(), current_basis("g++", 1, false).key());
}
}  // namespace testat
