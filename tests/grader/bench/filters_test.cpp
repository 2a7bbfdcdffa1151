#include "bench/filters.h"

#include "bench/errors.h"
#include "bench/float_error.h"
#include "bench/measure.h"
#include "bench/patterns.h"
#include "bench/truth.h"

#include <gtest/gtest.h>

#include <cmath>

namespace testat::bench {
namespace {
Pattern const grey = {"grey", {"grau", "grey"}, [](int, int, int) { return glm::dvec3(0.25, 0.5, 0.75); }};

Colours filtered(LookUp const& look_up, Footprints const& footprints)
{
    Colours colours(footprints.size());
    look_up(footprints.data(), footprints.size(), colours.data());
    return colours;
}

Filter const& filter(std::string const& id)
{
    for (auto const& one : filters())
        if (one.id == id)
            return one;
    throw std::out_of_range(id);
}

/// From magnified to far larger than the texture, round and thin, and none at all. Not a multiple of four.
Footprints all_kinds()
{
    Footprints all = {{{0.3f, 0.6f}, {}, {}, {}}};
    for (float size = 1e-4f; size < 10; size *= 3)
        for (float ratio : {1.f, 0.3f, 0.01f, 0.f})
            for (float angle : {0.f, 0.5f, 1.6f}) {
                glm::vec2 const dx = size * glm::vec2(std::cos(angle), std::sin(angle));
                glm::vec2 const dy = ratio * glm::vec2(-dx.y, dx.x);
                all.push_back({{3 * size - 2, angle}, dx, dy, glm::abs(dx) + glm::abs(dy)});
            }
    return all;
}

class EachFilter : public testing::TestWithParam<Filter> {};

TEST_P(EachFilter, KeepsOneColour)
{
    for (int side : {1, 2, 64})
        for (auto const& c : filtered(GetParam().prepare(make_texture(grey, side)), all_kinds()))
            for (int i = 0; i < 3; ++i)
                EXPECT_NEAR(c[i], 0.25 * (i + 1), 1e-6) << side;
}

TEST_P(EachFilter, DoesNotLeaveTheRangeOfTheTexture)
{
    for (auto const& c : filtered(GetParam().prepare(make_texture(patterns()[2], 64)), all_kinds()))
        for (int i = 0; i < 3; ++i)
            EXPECT_TRUE(c[i] >= -1e-6f && c[i] <= 1 + 1e-6f) << c[i];
}

/// Looked up one by one: nothing depends on the neighbours.
TEST_P(EachFilter, LooksUpEachFootprintForItself)
{
    LookUp const look_up = GetParam().prepare(make_texture(patterns()[2], 64));
    Footprints const all = all_kinds();
    Colours const together = filtered(look_up, all);
    for (std::size_t i = 0; i < all.size(); ++i)
        EXPECT_EQ(filtered(look_up, {all[i]})[0], together[i]) << i;
}

INSTANTIATE_TEST_SUITE_P(Filters, EachFilter, testing::ValuesIn(filters()), [](auto const& p) { return p.param.id; });

/// The fast ones, and the reference itself, in units of the bound that the unit checks allow, however far away.
TEST(FastFilters, StayInsideTheBoundsOfTheSheetsFunctions)
{
    for (auto const& [id, function] : {std::pair("reference_bilinear", Function::evaluate_bilinear),
                                       {"fast_bilinear", Function::evaluate_bilinear},
                                       {"reference_trilinear", Function::evaluate_trilinear},
                                       {"fast_trilinear", Function::evaluate_trilinear}})
        for (int decade = 0; decade < decades; ++decade) {
            FarLookups const far = far_lookups(function, decade);
            EXPECT_LE(worst_error(ask(filter(id).prepare(far.textures[0]), far.group), far.textures), 1)
                << id << " 10^" << decade;
        }
}

TEST(FarLookups, KeepToTheContract)
{
    for (int decade = 0; decade < decades; ++decade) {
        FarLookups const far = far_lookups(Function::evaluate_bilinear, decade);
        float farthest = 0;
        for (std::uint32_t i = 0; i < far.group.count; ++i)
            farthest = std::max(farthest, std::abs(question<LookupQuestion>(far.group, i).uv[0]));
        EXPECT_LT(farthest * far.textures[0].levels[0].width, 0x1p23);
        EXPECT_GT(farthest, 0.9 * std::pow(10, decade));
    }
}

TEST(FastNearest, IsTheReferencesToTheLastBit)
{
    TextureData const texture = make_texture(patterns()[2], 64);
    EXPECT_EQ(filtered(filter("fast_nearest").prepare(texture), all_kinds()),
              filtered(filter("reference_nearest").prepare(texture), all_kinds()));
}

/// RMSE on the checker in pictures of 64 pixels.
struct CheckerErrors {
    double operator()(std::string const& id, Scene const& scene)
    {
        View const view = look_at(scene, 64);
        Truth const truth = find_truth(scene, view, {texture}, 24)[0];
        return rmse(filtered(filter(id).prepare(texture), view.footprints), truth);
    }
    TextureData texture = make_texture(patterns()[0], 256);
};

/// What the README promises.
TEST(Anisotropic, WithFourProbesErrsByAThirdOfTrilinear)
{
    CheckerErrors error;
    for (auto const& scene : scenes()) {
        double const trilinear = error("fast_trilinear", scene);
        double const four = error("anisotropic_4", scene);
        EXPECT_LE(four, 0.35 * trilinear) << scene.id;
        EXPECT_LT(error("anisotropic_16", scene), four) << scene.id;
    }
}

TEST(Ripmap, HelpsMostWhereFootprintsLieAlongTheAxes)
{
    CheckerErrors error;
    auto const gain = [&](Scene const& scene) { return error("ripmap", scene) / error("fast_trilinear", scene); };
    EXPECT_LT(gain(scenes()[0]), gain(scenes()[2]));
}

TEST(Measure, GivesEachFilterATimeAndItsColours)
{
    TextureData const texture = make_texture(patterns()[2], 16);
    LookUp const nearest = filter("fast_nearest").prepare(texture);
    auto const measured = measure({nearest, filter("ewa").prepare(texture)}, all_kinds(), 2);
    ASSERT_EQ(measured.size(), 2u);
    EXPECT_EQ(measured[0].colours, filtered(nearest, all_kinds()));
    for (auto const& one : measured)
        EXPECT_TRUE(one.seconds >= 0 && one.seconds < HUGE_VAL);
}
}  // namespace
}  // namespace testat::bench
