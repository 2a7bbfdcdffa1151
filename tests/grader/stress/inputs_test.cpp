// Generators keep to the contracts that they state, reach their ends, and depend on seed and block alone.
#include "checks/vectors.h"
#include "stress/stress.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace testat {
namespace {
constexpr std::uint32_t some = 4096;

Subject const& subject(Function function)
{
    auto const& all = subjects();
    return *std::find_if(all.begin(), all.end(), [&](Subject const& s) { return s.function == function; });
}

Block inside(Function function, std::uint32_t questions = some, std::uint64_t seed = 1)
{
    return stress_block(subject(function), true, 0, questions, seed);
}

/// Calls `test(question, textures)` for every question inside the contract.
template <typename Question, typename Test>
void for_each_inside(Function function, Test const& test)
{
    for (std::uint64_t seed : {1, 2, 3}) {
        Block const block = inside(function, some, seed);
        for (std::uint32_t i = 0; i < block.group.count; ++i)
            test(question<Question>(block.group, i), block.textures);
    }
}

bool all_finite(float const* numbers, std::size_t size)
{
    return std::all_of(numbers, numbers + size, [](float x) { return std::isfinite(x); });
}

class Inputs : public testing::TestWithParam<Subject> {};

TEST_P(Inputs, AreWellFormed)
{
    for (bool in_contract : {true, false}) {
        Group const group = stress_block(GetParam(), in_contract, 0, 64, 1).group;
        EXPECT_EQ(group.count, 64u);
        EXPECT_EQ(group.questions.size(), std::size_t(64) * question_bytes(group.kind));
        EXPECT_GT(group.words_per_answer, 0u);
        EXPECT_EQ(group.under_test, GetParam().function);
        EXPECT_EQ(group.from_upload, FunctionSet::only(GetParam().function));
    }
}

TEST_P(Inputs, DependOnSeedAndBlock)
{
    auto const bytes = [](std::uint32_t block, std::uint64_t seed) {
        Block const made = stress_block(GetParam(), true, block, 64, seed);
        std::vector<std::byte> all = serialize({{}, {}, made.textures, {}});
        all.insert(all.end(), made.group.questions.begin(), made.group.questions.end());
        return all;
    };
    EXPECT_EQ(bytes(3, 5), bytes(3, 5));
    EXPECT_NE(bytes(3, 5), bytes(4, 5));
    EXPECT_NE(bytes(3, 5), bytes(3, 6));
}

INSTANTIATE_TEST_SUITE_P(Functions, Inputs, testing::ValuesIn(subjects()),
                         [](auto const& p) { return std::string(testat::info(p.param.function).name); });

TEST(Subjects, AreAllElevenInTheOrderOfTheSheet)
{
    ASSERT_EQ(subjects().size(), function_count);
    for (std::uint32_t i = 0; i < function_count; ++i)
        EXPECT_EQ(static_cast<std::uint32_t>(subjects()[i].function), i);
}

/// Weights that are wrong in their last digits show at fractions only.
TEST(LookupInputs, AreNearFractionsOftenEnough)
{
    for (Function f : {Function::evaluate_nearest, Function::evaluate_bilinear, Function::evaluate_trilinear}) {
        int near = 0, all = 0;
        for_each_inside<LookupQuestion>(f, [&](LookupQuestion const& q, Textures const&) {
            ++all;
            near += std::all_of(q.uv, q.uv + 2, [](float u) { return std::abs(u) > 1e-3f && std::abs(u) < 3; }) ? 1 : 0;
        });
        EXPECT_GT(4 * near, all) << info(f).name;
    }
}

TEST(WrapInputs, KeepToTheContractAndReachItsEnds)
{
    std::set<int> values, sizes;
    for_each_inside<WrapQuestion>(Function::wrap_repeat, [&](WrapQuestion const& q, Textures const&) {
        EXPECT_TRUE(std::abs(q.val) <= 1'000'000 && q.size >= 1 && q.size <= 16384) << q.val << " " << q.size;
        values.insert(q.val);
        sizes.insert(q.size);
    });
    EXPECT_EQ(*values.begin(), -1'000'000);
    EXPECT_EQ(*values.rbegin(), 1'000'000);
    EXPECT_EQ(*sizes.begin(), 1);
    EXPECT_EQ(*sizes.rbegin(), 16384);
}

TEST(WrapInputs, ReachBothEndsOfIntOutside)
{
    Group const group = stress_block(subject(Function::wrap_clamp), false, 0, some, 1).group;
    std::set<int> values;
    for (std::uint32_t i = 0; i < group.count; ++i)
        values.insert(question<WrapQuestion>(group, i).val);
    EXPECT_EQ(*values.begin(), std::numeric_limits<int>::min());
    EXPECT_EQ(*values.rbegin(), std::numeric_limits<int>::max());
}

TEST(LookupInputs, KeepToTheContract)
{
    for (Function f : {Function::evaluate_nearest, Function::evaluate_bilinear, Function::evaluate_trilinear})
        for_each_inside<LookupQuestion>(f, [](LookupQuestion const& q, Textures const& textures) {
            glm::dvec2 const size = level_size(textures.at(q.texture), 0);
            EXPECT_LT(std::abs(q.uv[0]) * size.x, 0x1p23);
            EXPECT_LT(std::abs(q.uv[1]) * size.y, 0x1p23);
            EXPECT_TRUE(all_finite(q.uv, 2) && all_finite(q.dudv, 2));
            EXPECT_TRUE(q.dudv[0] >= 0 && q.dudv[1] >= 0);
            EXPECT_TRUE(q.level >= 0 && q.level < int(textures[q.texture].levels.size()));
            EXPECT_LE(std::max(size.x, size.y), 16384);
        });
}

/// A texture that is as long as any, one of a single texel, rows and columns.
TEST(LookupInputs, HaveTexturesOfAllShapes)
{
    std::set<int> widths, heights;
    for (std::uint32_t block = 0; block < 40; ++block)
        for (auto const& texture : stress_block(subject(Function::evaluate_bilinear), true, block, 1, 1).textures) {
            widths.insert(level_size(texture, 0).x);
            heights.insert(level_size(texture, 0).y);
        }
    for (auto const& sides : {widths, heights}) {
        EXPECT_EQ(*sides.begin(), 1);
        EXPECT_EQ(*sides.rbegin(), 16384);
    }
}

TEST(MipmapInputs, ArePowersOfTwo)
{
    auto const is_power = [](int n) { return n >= 1 && n <= 16384 && (n & (n - 1)) == 0; };
    for (auto const& texture : inside(Function::create_mipmap, 256).textures) {
        glm::ivec2 const size = level_size(texture, 0);
        EXPECT_TRUE(is_power(size.x) && is_power(size.y)) << size.x << " x " << size.y;
        EXPECT_EQ(texture.levels.size(), 1u);
        EXPECT_TRUE(all_finite(texture.levels[0].texels.data(), texture.levels[0].texels.size()));
    }
}

TEST(TransformInputs, AreAffineAndInvertibleOfAllScales)
{
    double least = HUGE_VAL;
    double most = 0;
    for (Function f : {Function::transform_direction, Function::transform_position})
        for_each_inside<TransformQuestion>(f, [&](TransformQuestion const& q, Textures const&) {
            EXPECT_TRUE(all_finite(q.matrix, 16) && all_finite(q.vector, 3));
            EXPECT_TRUE(q.matrix[3] == 0 && q.matrix[7] == 0 && q.matrix[11] == 0 && q.matrix[15] == 1);
            double const determinant = std::abs(glm::determinant(glm::dmat3(dmat4(q.matrix))));
            least = std::min(least, determinant);
            most = std::max(most, determinant);
        });
    EXPECT_GT(least, 0);
    EXPECT_LT(least, 1e-30);
    EXPECT_GT(most, 1e30);
}

TEST(DirectionInputs, CanBeNormalisedInFloat)
{
    for_each_inside<TransformQuestion>(Function::transform_direction, [](TransformQuestion const& q, Textures const&) {
        double const length = glm::length(glm::dmat3(dmat4(q.matrix)) * dvec3(q.vector));
        EXPECT_TRUE(length >= 1e-18 && length <= 1e18) << length;
    });
    for_each_inside<TangentSpaceQuestion>(Function::transform_direction_to_object_space,
                                          [](TangentSpaceQuestion const& q, Textures const&) {
                                              for (float const* axis : {q.normal, q.tangent, q.bitangent})
                                                  EXPECT_NEAR(glm::length(dvec3(axis)), 1, 1e-6);
                                              EXPECT_GT(glm::length(dvec3(q.d)), 1e-18);
                                          });
}

TEST(IntersectInputs, HaveMatricesThatFloatCanInvert)
{
    for_each_inside<IntersectQuestion>(Function::intersect, [](IntersectQuestion const& q, Textures const&) {
        glm::dmat4 const m = dmat4(q.object_to_world);
        double const determinant = std::abs(glm::determinant(glm::dmat3(m)));
        EXPECT_TRUE(determinant >= 0x1p-125 && determinant <= 0x1p125) << determinant;
        EXPECT_NEAR(glm::length(dvec3(q.direction)), 1, 1e-6);
        EXPECT_LE(glm::length(dvec3(q.origin)), 1e18);
    });
}

TEST(FootprintInputs, HaveUnitFramesAndDirections)
{
    for_each_inside<FootprintQuestion>(Function::compute_uv_aabb_size, [](FootprintQuestion const& q, Textures const&) {
        EXPECT_NEAR(glm::length(dvec3(q.normal)), 1, 1e-6);
        for (auto const& direction : q.direction)
            EXPECT_NEAR(glm::length(dvec3(direction)), 1, 1e-6);
        EXPECT_TRUE(all_finite(q.position, 3) && all_finite(q.uv, 2));
    });
}
}  // namespace
}  // namespace testat
