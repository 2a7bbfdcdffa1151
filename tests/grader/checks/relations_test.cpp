#include "checks/relations.h"

#include "checks/vectors.h"
#include "installation.h"
#include "reference_answers.h"
#include "rubric/rubric.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace testat {
namespace {
constexpr std::uint64_t uploads = 60;

/// In the order of the sheet.
std::vector<std::string> const metamorphic = {
    "EvaluateNearest.MirroredTexture",   "WrapClamp.MirroredRange",
    "WrapRepeat.WholePeriods",           "EvaluateBilinear.LinearInTheTexture",
    "CreateMipmap.LinearInTheTexture",   "ComputeUvAabbSize.ScaledScene",
    "EvaluateTrilinear.MirroredTexture", "TransformDirection.RotatedMatrix",
    "TransformPosition.MovedMatrix",     "Intersect.MovedScene",
    "TangentSpace.RotatedFrame",
};

UnitCheck const& check_of(Function function)
{
    auto const& name = metamorphic.at(static_cast<std::uint32_t>(function));
    auto const& all = unit_checks();
    return *std::find_if(all.begin(), all.end(), [&](auto const& check) { return check.name == name; });
}

/// Something like a SHA-256, another one for each number.
std::string upload(std::uint64_t number)
{
    return "sha256 of upload " + std::to_string(number);
}

Textures textures_of(std::uint64_t number)
{
    return make_test_textures(1 + number % 3, upload(number));
}

/// Calls `test(check, questions, textures)` for every metamorphic check and some uploads.
template <typename Test>
void for_every_check(Test const& test)
{
    for (std::uint64_t number = 0; number < uploads; ++number) {
        Textures const textures = textures_of(number);
        for (Function f : every_function()) {
            UnitCheck const& check = check_of(f);
            SCOPED_TRACE(check.name + ", upload " + std::to_string(number));
            test(check, questions_of(check, 1, textures), textures);
        }
    }
}

void set_word(Answers& answers, std::uint32_t index, std::size_t word, float value)
{
    std::memcpy(&answers.words[std::size_t(index) * answers.group.words_per_answer + word], &value, sizeof value);
}

/// How many uploads a function of the questions passes the metamorphic check with.
template <typename Question, typename F>
std::uint64_t passed(Function function, F const& f)
{
    std::uint64_t count = 0;
    for (std::uint64_t number = 0; number < uploads; ++number) {
        Textures const textures = textures_of(number);
        Answers answers = constant_answers(questions_of(check_of(function), 1, textures), 0);
        for (std::uint32_t i = 0; i < answers.group.count; ++i) {
            auto const q = question<Question>(answers.group, i);
            if constexpr (std::is_same_v<Question, WrapQuestion>) {
                answers.words[i] = std::uint32_t(f(q));
            } else {
                auto const value = f(q, textures);
                for (int c = 0; c < value.length(); ++c)
                    set_word(answers, i, std::size_t(c), float(value[c]));
            }
        }
        count += check_of(function).judge(answers, textures).passed() ? 1 : 0;
    }
    return count;
}

template <typename F>
std::uint64_t nearest_passed(F const& texel_of)
{
    return passed<LookupQuestion>(Function::evaluate_nearest, [&](LookupQuestion const& q, Textures const& textures) {
        auto const& texture = textures[q.texture];
        glm::vec2 const size(level_size(texture, q.level));
        glm::ivec2 const at = texel_of(q.uv[0] * size.x, q.uv[1] * size.y);
        return texel(texture, q.level, at.x, at.y);
    });
}

/// Bilinear with `shift` subtracted from st, and weights that `weight` makes from a fraction.
template <typename Weight>
std::uint64_t bilinear_passed(float shift, Weight const& weight)
{
    return passed<LookupQuestion>(Function::evaluate_bilinear, [&](LookupQuestion const& q, Textures const& textures) {
        auto const& texture = textures[q.texture];
        glm::vec2 const st = glm::vec2(q.uv[0], q.uv[1]) * glm::vec2(level_size(texture, q.level)) - shift;
        glm::ivec2 const first(glm::floor(st));
        auto const row = [&](int y) {
            return glm::mix(glm::vec4(texel(texture, q.level, first.x, y)),
                            glm::vec4(texel(texture, q.level, first.x + 1, y)), weight(st.x - float(first.x)));
        };
        return glm::mix(row(first.y), row(first.y + 1), weight(st.y - float(first.y)));
    });
}

template <typename F>
std::uint64_t repeat_passed(F const& f)
{
    return passed<WrapQuestion>(Function::wrap_repeat, [&](WrapQuestion const& q) { return f(q.val, q.size); });
}

template <typename F>
std::uint64_t clamp_passed(F const& f)
{
    return passed<WrapQuestion>(Function::wrap_clamp, [&](WrapQuestion const& q) { return f(q.val, q.size); });
}

/// Levels of all sizes; `keep` says what of the right texels is left.
template <typename Keep>
std::uint64_t mipmap_passed(Keep const& keep)
{
    std::uint64_t count = 0;
    for (std::uint64_t number = 0; number < uploads; ++number) {
        Textures const textures = textures_of(number);
        UnitCheck const& check = check_of(Function::create_mipmap);
        Answers answers = reference_answers(questions_of(check, 1, textures), textures);
        for (std::uint32_t i = 0; i < answers.group.count; ++i) {
            std::size_t word = MipmapLayout::header_words;
            for (int size = 64; size >= 1; size /= 2)
                for (int texel = 0; texel < size * size; ++texel, word += 4)
                    for (std::size_t c = 0; c < 4 && size < 64; ++c)
                        set_word(answers, i, word + c,
                                 floats<1>(answers, i, word + c)[0] * keep(i, size, texel % size, texel / size));
        }
        count += check.judge(answers, textures).passed() ? 1 : 0;
    }
    return count;
}

/// The reference's answers to another upload's questions: what a table would hold.
Answers answers_from_a_table(UnitCheck const& check, Group const& asked)
{
    Textures const others = textures_of(uploads + 1);
    Answers answers = reference_answers(questions_of(check, 1, others), others);
    answers.group = asked;
    return answers;
}
}  // namespace

TEST(MetamorphicChecks, AreOneForEachFunction)
{
    for (Function f : every_function()) {
        EXPECT_EQ(check_of(f).name, metamorphic[static_cast<std::uint32_t>(f)]);
        EXPECT_EQ(check_of(f).function, f);
    }
}

TEST(MetamorphicChecks, AreEssentialAndPublicAndGiveNoPoints)
{
    for (auto const& function : read_rubric(installation().rubric).functions)
        for (auto const& check : function.checks)
            if (check.name == check_of(function.function).name) {
                EXPECT_TRUE(check.essential && check.is_public) << check.name;
                EXPECT_EQ(check.weight, 0) << check.name;
            }
}

TEST(MetamorphicChecks, AskEveryUploadSomethingElse)
{
    Textures const one = make_test_textures(1, upload(1));
    Textures const other = make_test_textures(1, upload(2));
    for (Function f : every_function()) {
        Group const a = questions_of(check_of(f), 1, one);
        Group const b = questions_of(check_of(f), 1, other);
        EXPECT_TRUE(a.questions != b.questions || f == Function::create_mipmap) << check_of(f).name;
        EXPECT_EQ(a.questions, questions_of(check_of(f), 1, make_test_textures(1, upload(1))).questions);
    }
    EXPECT_NE(at(one, TestTexture::unknown_mip).levels[0].texels, at(other, TestTexture::unknown_mip).levels[0].texels);
}

/// The answers to the first half of their questions may be known beforehand, those to the second may not.
TEST(UnitChecks, DependOnTheUploadInTheirSecondHalf)
{
    Textures const one = make_test_textures(1, upload(1));
    Textures const other = make_test_textures(1, upload(2));
    for (auto const& check : unit_checks())
        if (!check.is_metamorphic) {
            auto const a = questions_of(check, 1, one).questions;
            auto const b = questions_of(check, 1, other).questions;
            ASSERT_EQ(a.size(), b.size());
            auto const half = std::ptrdiff_t(check.function == Function::create_mipmap ? a.size() : a.size() / 2);
            EXPECT_TRUE(std::equal(a.begin(), a.begin() + half, b.begin())) << check.name;
            EXPECT_EQ(std::equal(a.begin() + half, a.end(), b.begin() + half), half == std::ptrdiff_t(a.size()))
                << check.name;
        }
    for (std::size_t i = 0; i < std::size_t(TestTexture::unknown_mip); ++i)
        EXPECT_EQ(one[i].levels[0].texels, other[i].levels[0].texels) << i;
}

TEST(MetamorphicChecks, AcceptTheReferenceForManyUploads)
{
    for_every_check([](UnitCheck const& check, Group const& group, Textures const& textures) {
        Verdict const verdict = check.judge(reference_answers(group, textures), textures);
        EXPECT_TRUE(verdict.passed()) << verdict.deviation().measured << "\nexpected " << verdict.deviation().expected
                                      << "\nin bounds " << verdict.deviation().in_bounds;
    });
}

TEST(MetamorphicChecks, RejectOneAnswerForAll)
{
    for (float value : {0.f, 0.5f, 1.f})
        for_every_check([&](UnitCheck const& check, Group const& group, Textures const& textures) {
            std::uint32_t word;
            std::memcpy(&word, &value, sizeof word);
            EXPECT_FALSE(check.judge(constant_answers(group, word), textures).passed()) << value;
            EXPECT_FALSE(check.judge(constant_answers(group, std::uint32_t(value)), textures).passed()) << value;
        });
}

TEST(MetamorphicChecks, RejectWhatWasRightForAnotherUpload)
{
    for_every_check([](UnitCheck const& check, Group const& group, Textures const& textures) {
        if (check.function != Function::create_mipmap) {  // levels of three textures that are not these fit each other
            EXPECT_FALSE(check.judge(answers_from_a_table(check, group), textures).passed());
        }
    });
}

/// Answers that follow from the number of the call alone would fit relations that are asked one after the other.
TEST(MetamorphicChecks, RejectCounters)
{
    for_every_check([](UnitCheck const& check, Group const& group, Textures const& textures) {
        for (std::uint32_t step : {1u, 2u, 3u}) {
            Answers answers = constant_answers(group, 0);
            for (std::uint32_t i = 0; i < group.count; ++i)
                for (std::size_t w = 0; w < group.words_per_answer; ++w)
                    set_word(answers, i, w, std::floor(float(i) / float(step)));
            EXPECT_FALSE(check.judge(answers, textures).passed()) << step;
        }
    });
}

TEST(MetamorphicChecks, RejectOneAnswerThatFitsNoOther)
{
    for_every_check([](UnitCheck const& check, Group const& group, Textures const& textures) {
        Answers answers = reference_answers(group, textures);
        std::uint32_t& word = answers.words[(group.count / 2) * group.words_per_answer];
        word = group.kind == Kind::wrap || group.kind == Kind::intersect ? word + 1 : unanswered;
        EXPECT_FALSE(check.judge(answers, textures).passed());
    });
}

// Mistakes that keep points elsewhere are not the metamorphic checks' to find.

TEST(MirroredTexture, LetsPassWhatTakesTheRightTexelInLowerHalves)
{
    EXPECT_EQ(nearest_passed([](float s, float t) { return glm::ivec2(std::floor(s), std::floor(t)); }), uploads);
    EXPECT_EQ(nearest_passed([](float s, float t) { return glm::ivec2(int(s), int(t)); }), uploads);
    EXPECT_EQ(nearest_passed([](float s, float t) { return glm::ivec2(std::round(s), std::round(t)); }), uploads);
}

TEST(MirroredTexture, RejectsOtherTexels)
{
    EXPECT_EQ(nearest_passed([](float s, float t) { return glm::ivec2(int(s) + 1, int(t)); }), 0u);
    EXPECT_EQ(nearest_passed([](float s, float t) { return glm::ivec2(int(t), int(s) / 2); }), 0u);
    EXPECT_EQ(nearest_passed([](float, float) { return glm::ivec2(3, 4); }), 0u);
}

TEST(LinearInTheTexture, LetsPassEveryFixedMixOfNeighbours)
{
    for (float shift : {0.5f, 0.f}) {
        EXPECT_EQ(bilinear_passed(shift, [](float fraction) { return fraction; }), uploads);
        EXPECT_EQ(bilinear_passed(shift, [](float fraction) { return 1 - fraction; }), uploads);
        EXPECT_EQ(bilinear_passed(shift, [](float) { return 0.f; }), uploads);
        EXPECT_EQ(bilinear_passed(shift, [](float fraction) { return std::round(fraction); }), uploads);
    }
}

TEST(MirroredRange, LetsPassWhatIsRightInTheRange)
{
    EXPECT_EQ(clamp_passed([](int val, int size) { return std::clamp(val, 0, size - 1); }), uploads);
    EXPECT_EQ(clamp_passed([](int val, int size) { return std::clamp(val, 0, size); }), uploads);
    EXPECT_EQ(clamp_passed([](int val, int size) { return std::min(val, size - 1); }), uploads);
    EXPECT_EQ(clamp_passed([](int val, int size) { return (val % size + size) % size; }), uploads);
}

TEST(MirroredRange, RejectsWhatIsNot)
{
    EXPECT_EQ(clamp_passed([](int, int size) { return size - 1; }), 0u);
    EXPECT_EQ(clamp_passed([](int val, int size) { return std::clamp(val, size / 8, size - 1); }), 0u);
    EXPECT_EQ(clamp_passed([](int val, int size) { return size - 1 - val; }), 0u);
}

TEST(WholePeriods, LetsPassWhatKeepsPoints)
{
    EXPECT_EQ(repeat_passed([](int val, int size) { return val % size; }), uploads);
    EXPECT_EQ(repeat_passed([](int val, int size) { return val >= size ? val - size : val; }), uploads) << "once only";
    EXPECT_EQ(repeat_passed([](int val, int) { return val; }), uploads) << "not at all";
    EXPECT_EQ(repeat_passed([](int val, int size) { return std::min(val, size - 1); }), uploads);
}

TEST(WholePeriods, RejectsATableOfWhatIsAlwaysAsked)
{
    EXPECT_EQ(repeat_passed([](int val, int size) { return size == 6 && val <= 24 ? val % 6 : val; }), 0u);
    EXPECT_EQ(
        repeat_passed([](int val, int size) { return size == 6 && val <= 24 ? val % 6 : std::min(val, size - 1); }),
        0u);
}

TEST(LevelsOfTheMean, LetPassWhatIsLinear)
{
    EXPECT_EQ(mipmap_passed([](auto, int, int, int) { return 1.f; }), uploads);
    EXPECT_EQ(mipmap_passed([](auto, int, int, int) { return 0.f; }), uploads) << "empty";
    EXPECT_EQ(mipmap_passed([](auto, int size, int, int) { return 4096.f / float(size * size); }), uploads)
        << "not divided";
    EXPECT_EQ(mipmap_passed([](auto, int size, int x, int y) { return x < size - 1 && y < size - 1 ? 1.f : 0.f; }),
              uploads);
}

TEST(LevelsOfTheMean, RejectOneOfThreeTextures)
{
    for (std::uint32_t known : {0u, 1u, 2u})
        EXPECT_EQ(mipmap_passed([=](std::uint32_t i, int, int, int) { return i == known ? 1.f : 0.f; }), 0u);
}

TEST(RotatedMatrix, LetsPassWhatIsNotNormalised)
{
    auto const product = [](TransformQuestion const& q, Textures const&) {
        return glm::dvec3(dmat4(q.matrix) * glm::dvec4(dvec3(q.vector), 0));
    };
    EXPECT_EQ(passed<TransformQuestion>(Function::transform_direction, product), uploads);
}

TEST(RotatedMatrix, RejectsWhatIgnoresMatrixOrVector)
{
    EXPECT_EQ(passed<TransformQuestion>(Function::transform_direction,
                                        [](TransformQuestion const& q, Textures const&) { return dvec3(q.vector); }),
              0u);
    EXPECT_EQ(passed<TransformQuestion>(
                  Function::transform_direction,
                  [](TransformQuestion const& q, Textures const&) { return glm::dvec3(dmat4(q.matrix)[0]); }),
              0u);
}

TEST(MovedMatrix, RejectsWhatIgnoresThePosition)
{
    EXPECT_EQ(passed<TransformQuestion>(
                  Function::transform_position,
                  [](TransformQuestion const& q, Textures const&) { return glm::dvec3(dmat4(q.matrix)[3]); }),
              0u);
}

TEST(RotatedFrame, LetsPassWhatIsNotNormalised)
{
    auto const product = [](TangentSpaceQuestion const& q, Textures const&) {
        return glm::dmat3(dvec3(q.tangent), dvec3(q.normal), dvec3(q.bitangent)) * dvec3(q.d);
    };
    EXPECT_EQ(passed<TangentSpaceQuestion>(Function::transform_direction_to_object_space, product), uploads);
}
}  // namespace testat
