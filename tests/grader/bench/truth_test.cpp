#include "bench/errors.h"
#include "bench/patterns.h"
#include "bench/truth_cache.h"
#include "process/run.h"

#include <gtest/gtest.h>

#include <fstream>

namespace testat::bench {
namespace {
Pattern const grey = {"grey", {"grau", "grey"}, [](int, int, int) { return glm::dvec3(0.25, 0.5, 0.75); }};

Sheet sheet_of(Pattern const& pattern, int side)
{
    return {pattern.id, make_texture(pattern, side), "hash of " + std::string(pattern.id)};
}

double largest_difference(Truth const& a, Truth const& b)
{
    double largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        for (int c = 0; c < 3; ++c)
            largest = std::max(largest, std::abs(a[i][c] - b[i][c]));
    return largest;
}

Truth truth_with(int strata, Pattern const& pattern)
{
    return find_truth(scenes()[1], look_at(scenes()[1], 16), {make_texture(pattern, 32)}, strata)[0];
}

TEST(Truth, OfOneColourIsThatColour)
{
    for (auto const& c : truth_with(4, grey))
        for (int i = 0; i < 3; ++i)
            EXPECT_NEAR(c[i], 0.25 * (i + 1), 1e-12);
}

TEST(Truth, ConvergesWithTheNumberOfSamples)
{
    Truth const best = truth_with(96, patterns()[0]);
    double const few = largest_difference(truth_with(4, patterns()[0]), best);
    double const many = largest_difference(truth_with(48, patterns()[0]), best);
    EXPECT_LT(many, few / 3);
    EXPECT_LT(many, 0.02);
}

TEST(Truth, HasTwoThousandSamplesAtLeast)
{
    EXPECT_GE(least_strata * least_strata, 2048);
}

TEST(Signal, IsTheTexelAtItsCentreAndTheMeanBetween)
{
    TextureData::Level const level = make_texture(patterns()[2], 8).levels[0];
    auto const texel = [&](int x, int y) {
        float const* c = &level.texels[std::size_t(4 * (8 * y + x))];
        return glm::dvec3(c[0], c[1], c[2]);
    };
    EXPECT_EQ(signal(level, {1.5 / 8, 2.5 / 8}), texel(1, 2));
    EXPECT_EQ(signal(level, {1.5 / 8 - 3, 2.5 / 8 + 5}), texel(1, 2));
    EXPECT_LT(glm::length(signal(level, {0, 2.5 / 8}) - (texel(7, 2) + texel(0, 2)) / 2.0), 1e-15);
}

TEST(TruthCache, KeepsWhatItFound)
{
    TemporaryDirectory const place;
    View const view = look_at(scenes()[3], 16);
    std::vector<Sheet> const sheets = {sheet_of(patterns()[0], 16), sheet_of(patterns()[2], 16)};
    auto const first = truth_of(scenes()[3], view, sheets, place.path(), 4);
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(place.path()), {}), 2);
    EXPECT_EQ(truth_of(scenes()[3], view, sheets, place.path(), 4), first);
    EXPECT_EQ(truth_of(scenes()[3], view, sheets, {}, 4), first);
    EXPECT_NE(first[0], first[1]);
}

TEST(TruthCache, FindsDamagedFilesAgain)
{
    TemporaryDirectory const place;
    View const view = look_at(scenes()[3], 16);
    std::vector<Sheet> const sheets = {sheet_of(patterns()[0], 16)};
    auto const right = truth_of(scenes()[3], view, sheets, place.path(), 4);
    auto const file = std::filesystem::directory_iterator(place.path())->path();
    for (std::string const& damage :
         {std::string("short"), std::string(right[0].size() * sizeof(glm::dvec3), '\xff')}) {
        std::ofstream(file, std::ios::binary) << damage;
        EXPECT_EQ(truth_of(scenes()[3], view, sheets, place.path(), 4), right);
    }
}

TEST(TruthCache, DoesWithoutAFolder)
{
    View const view = look_at(scenes()[3], 16);
    EXPECT_NO_THROW(truth_of(scenes()[3], view, {sheet_of(patterns()[0], 16)}, "/proc/none", 2));
}
}  // namespace
}  // namespace testat::bench
