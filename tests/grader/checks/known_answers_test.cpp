#include "checks/matrices.h"
#include "checks/shapes.h"
#include "reference_answers.h"

#include <gtest/gtest.h>
#include <glm/gtc/matrix_transform.hpp>

/// Questions with answers that can be worked out on paper.
namespace testat {
namespace {
UnitCheck const& find_check(std::string const& name)
{
    for (auto const& check : unit_checks())
        if (check.name == name)
            return check;
    throw std::runtime_error("no check " + name);
}

/// Whether the check accepts these words as the answer to this one question.
template <typename Question, typename Word>
bool accepts(std::string const& name, Kind kind, Question const& question, std::vector<Word> const& words)
{
    static Textures const textures = make_test_textures(1);
    Answers answers = constant_answers(make_group(kind, std::vector<Question>{question}), 0);
    std::memcpy(answers.words.data(), words.data(), std::min(answers.words.size(), words.size()) * sizeof(Word));
    return find_check(name).judge(answers, textures).passed();
}

bool wraps(std::string const& name, int val, int size, int answer)
{
    return accepts(name, Kind::wrap, WrapQuestion{val, size}, std::vector<std::int32_t>{answer});
}

bool is_texel(std::string const& check, LookupQuestion const& q, std::vector<float> const& colour)
{
    return accepts("EvaluateNearest." + check, Kind::lookup, q, colour);
}

LookupQuestion at_texel(TestTexture texture, int level, glm::vec2 st, glm::vec2 size)
{
    return {static_cast<std::uint32_t>(texture), level, {st.x / size.x, st.y / size.y}, {}};
}

/// From `eye`, the corners' rays through eye + forward +- x +- y.
FootprintQuestion footprint(Shape const& shape, glm::dvec3 position, glm::dvec3 normal, glm::dvec3 eye,
                            glm::dvec3 forward, glm::dvec3 x, glm::dvec3 y)
{
    constexpr double signs[4][2] = {{-1, -1}, {1, 1}, {-1, 1}, {1, -1}};
    FootprintQuestion q{};
    q.shape = shape;
    store(position, q.position);
    store(normal, q.normal);
    store(map_uv(shape, position), q.uv);
    for (int i = 0; i < 4; ++i) {
        store(eye, q.origin[i]);
        store(glm::normalize(forward + signs[i][0] * x + signs[i][1] * y), q.direction[i]);
    }
    return q;
}

bool is_size(FootprintQuestion const& q, float du, float dv)
{
    return accepts("ComputeUvAabbSize.AxisAligned", Kind::footprint, q, std::vector<float>{du, dv});
}

TransformQuestion transform(glm::dmat4 const& matrix, glm::dvec3 vector)
{
    TransformQuestion q{};
    store(matrix, q.matrix);
    store(vector, q.vector);
    return q;
}

bool transforms(std::string const& check, TransformQuestion const& q, std::vector<float> const& to)
{
    return accepts(check, Kind::transform, q, to);
}

/// The unit sphere, stretched, from (0, 0, 5) towards the origin.
IntersectQuestion stretched_sphere(glm::dvec3 scale)
{
    IntersectQuestion q{};
    q.shape = make_sphere({0, 0, 0}, 1, 1);
    q.transform_objects = 1;
    store(glm::scale(glm::dmat4(1), scale), q.object_to_world);
    store(glm::dvec3(0, 0, 5), q.origin);
    store(glm::dvec3(0, 0, -1), q.direction);
    return q;
}

struct WorldHit {
    std::int32_t hit;
    float t;
    float vectors[9];
};

bool meets(std::string const& check, IntersectQuestion const& q, WorldHit const& hit)
{
    return accepts("Intersect." + check, Kind::intersect, q, std::vector<WorldHit>{hit});
}

WorldHit const top = {1, 3, {0, 0, 2, 0, 0, 1, 0, 0, 1}};
}  // namespace

TEST(WrapRepeatCheck, KnowsTheSheetsFigure)
{
    int const right[] = {5, 0, 1, 2, 3, 4, 5, 0, 1, 2, 3, 4, 5, 0, 1};  // for -7 to 7
    for (int val = -7; val <= 7; ++val)
        for (int answer = -1; answer <= 6; ++answer)
            EXPECT_EQ(wraps("WrapRepeat.NegativeIndices", val, 6, answer), answer == right[val + 7]) << val;
}

TEST(WrapClampCheck, KnowsTheSheetsFigure)
{
    int const right[] = {0, 0, 0, 0, 0, 0, 0, 0, 1, 2, 3, 4, 5, 5, 5};  // for -7 to 7
    for (int val = -7; val <= 7; ++val)
        for (int answer = -1; answer <= 6; ++answer)
            EXPECT_EQ(wraps("WrapClamp.InsideTheRange", val, 6, answer), answer == right[val + 7]) << val;
}

TEST(EvaluateNearestCheck, KnowsTheTexel)
{
    auto const q = at_texel(TestTexture::coded_square, 0, {3.5f, 5.25f}, {16, 16});
    EXPECT_TRUE(is_texel("SquareLevelZero", q, {0, 3, 5, 1}));
    EXPECT_FALSE(is_texel("SquareLevelZero", q, {0, 4, 5, 1}));
    EXPECT_FALSE(is_texel("SquareLevelZero", q, {0, 5, 3, 1}));
    EXPECT_FALSE(is_texel("SquareLevelZero", q, {1, 3, 5, 1}));
}

TEST(EvaluateNearestCheck, KnowsNegativeTexels)
{
    auto const repeated = at_texel(TestTexture::coded_wide, 0, {-0.75f, -8.25f}, {32, 8});
    EXPECT_TRUE(is_texel("NegativeCoordinates", repeated, {0, 31, 7, 1}));
    EXPECT_FALSE(is_texel("NegativeCoordinates", repeated, {0, 0, 0, 1})) << "cast";
    auto const outside = at_texel(TestTexture::coded_wide_zero, 0, {-0.75f, 2.5f}, {32, 8});
    EXPECT_TRUE(is_texel("NegativeCoordinates", outside, {0, 0, 0, 0}));
    EXPECT_FALSE(is_texel("NegativeCoordinates", outside, {0, 0, 2, 1}));
}

TEST(EvaluateNearestCheck, AcceptsBothTexelsAtTheirBorder)
{
    LookupQuestion const q = at_texel(TestTexture::coded_square, 0, {0.99999999f * 3, 0.5f}, {16, 16});
    EXPECT_TRUE(is_texel("SquareLevelZero", q, {0, 2, 0, 1}));
    EXPECT_TRUE(is_texel("SquareLevelZero", q, {0, 3, 0, 1}));
    EXPECT_FALSE(is_texel("SquareLevelZero", q, {0, 1, 0, 1}));
}

TEST(ComputeUvAabbSizeCheck, KnowsAPlaneFromAbove)
{
    Shape const plane = make_plane({0, 0, 0}, {0, 1, 0}, {1, 0, 0}, 2);
    auto const q = footprint(plane, {0, 0, 0}, {0, 1, 0}, {0, 1, 0}, {0, -1, 0}, {0.125, 0, 0}, {0, 0, 0.25});
    EXPECT_TRUE(is_size(q, 0.125f, 0.25f));
    EXPECT_FALSE(is_size(q, 0.25f, 0.125f));
    EXPECT_FALSE(is_size(q, 0.125f, 0.25001f));
}

TEST(ComputeUvAabbSizeCheck, KnowsTheTangentPlaneOfASphere)
{
    // The corners are (+-1, +-1, -1) on the plane z = -1: u is 1/8 or 3/8, v is 1 - acos(+-1/sqrt(3)) / pi.
    auto const q = footprint(make_sphere({0, 0, 0}, 1, 1), {0, 0, -1}, {0, 0, -1}, {0, 0, -3}, {0, 0, 1}, {0.5, 0, 0},
                             {0, 0.5, 0});
    EXPECT_TRUE(is_size(q, 0.25f, 0.39182655f));
    EXPECT_FALSE(is_size(q, 0.25f, 0.3918f));
    EXPECT_FALSE(is_size(q, 0.2501f, 0.39182655f));
}

TEST(ComputeUvAabbSizeCheck, KnowsThatAMissStaysAtTheCentre)
{
    Shape const plane = make_plane({0, 0, 0}, {0, 1, 0}, {1, 0, 0}, 1);
    auto q = footprint(plane, {0, 0, 0}, {0, 1, 0}, {0, 1, 0}, {0, -1, 0}, {0.125, 0, 0}, {0, 0, 0.25});
    for (int missing : {1, 3})
        store(glm::dvec3(0, 1, 0), q.direction[missing]);
    EXPECT_TRUE(is_size(q, 0.125f, 0.5f)) << "the half with positive x is gone";
    EXPECT_FALSE(is_size(q, 0.25f, 0.5f));
}

TEST(TransformDirectionCheck, KnowsAQuarterTurn)
{
    glm::dmat4 const turn = glm::translate(glm::dmat4(1), glm::dvec3(1, 2, 3)) *
                            glm::rotate(glm::dmat4(1), glm::half_pi<double>(), {0, 0, 1});
    EXPECT_TRUE(transforms("TransformDirection.Rotations", transform(turn, {1, 0, 0}), {0, 1, 0}));
    EXPECT_FALSE(transforms("TransformDirection.Rotations", transform(turn, {1, 0, 0}), {1, 3, 3}));
    EXPECT_FALSE(transforms("TransformDirection.Rotations", transform(turn, {1, 0, 0}), {0, -1, 0}));
    EXPECT_TRUE(transforms("TransformPosition.RigidMotions", transform(turn, {1, 0, 0}), {1, 3, 3}));
}

TEST(TransformDirectionCheck, WantsLengthOne)
{
    auto const q = transform(glm::scale(glm::dmat4(1), glm::dvec3(2, 3, 4)), {0, 0.5, 0});
    EXPECT_TRUE(transforms("TransformDirection.LengthIsOne", q, {0, 1, 0}));
    EXPECT_FALSE(transforms("TransformDirection.LengthIsOne", q, {0, 1.5, 0}));
    EXPECT_TRUE(transforms("TransformPosition.NonUniformScale", q, {0, 1.5, 0}));
}

TEST(IntersectCheck, KnowsTheDistanceToAStretchedSphere)
{
    IntersectQuestion const q = stretched_sphere({2, 2, 2});
    EXPECT_TRUE(meets("DistanceInTheWorld", q, top));
    EXPECT_FALSE(meets("DistanceInTheWorld", q, {1, 1.5f, {0, 0, 2, 0, 0, 1, 0, 0, 1}})) << "t of object space";
    EXPECT_TRUE(meets("DistanceInTheWorld", stretched_sphere({1, 0.5, 2}), top));
}

TEST(IntersectCheck, KnowsPlaceAndNormals)
{
    IntersectQuestion const q = stretched_sphere({2, 2, 2});
    EXPECT_TRUE(meets("PlaceInTheWorld", q, top));
    EXPECT_FALSE(meets("PlaceInTheWorld", q, {1, 3, {0, 0, 1, 0, 0, 1, 0, 0, 1}})) << "position of object space";
    EXPECT_FALSE(meets("PlaceInTheWorld", q, {1, 3, {0, 0, 2, 0, 0, -1, 0, 0, 1}})) << "normal turned round";
    EXPECT_FALSE(meets("PlaceInTheWorld", q, {1, 3, {0, 0, 2, 0, 0, 1, 0, 0, 0.5f}})) << "geometric normal scaled";
}

TEST(IntersectCheck, LooksAtNothingElseAfterAMiss)
{
    IntersectQuestion q = stretched_sphere({2, 2, 2});
    store(glm::dvec3(0, 0, 1), q.direction);
    EXPECT_TRUE(meets("PlaceInTheWorld", q, {0, NAN, {1, 2, 3, 4, 5, 6, 7, 8, 9}}));
    EXPECT_FALSE(meets("HitsAndMisses", q, top));
}

TEST(IntersectCheck, LeavesTheMatrixOutWithTransformsOff)
{
    IntersectQuestion q = stretched_sphere({2, 2, 2});
    q.transform_objects = 0;
    EXPECT_TRUE(meets("TransformsOff", q, {1, 4, {0, 0, 1, 0, 0, 1, 0, 0, 1}}));
    EXPECT_FALSE(meets("TransformsOff", q, top));
}

TEST(TangentSpaceCheck, KnowsItsAxes)
{
    TangentSpaceQuestion const q{{1, 2, 2}, {1, 0, 0}, {0, 0, 1}, {0, 1, 0}};  // normal x, tangent z, bitangent y
    auto const accepted = [&](std::vector<float> const& to) {
        return accepts("TangentSpace.LengthIsOne", Kind::tangent_space, q, to);
    };
    EXPECT_TRUE(accepted({2 / 3.f, 2 / 3.f, 1 / 3.f}));
    EXPECT_FALSE(accepted({2, 2, 1})) << "not normalised";
    EXPECT_FALSE(accepted({2 / 3.f, 1 / 3.f, 2 / 3.f})) << "inverse rotation";
}
}  // namespace testat
