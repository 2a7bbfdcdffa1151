// Files that know what the default seed asks and answer from a table: right there, and nowhere else.
#include "answers.h"
#include "checks/lookup.h"
#include "checks/run_checks.h"
#include "checks/vectors.h"
#include "end_to_end/testat_program.h"
#include "installation.h"
#include "rubric/rubric.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <set>

namespace testat {
namespace {
constexpr std::uint64_t default_seed = 1;

/// Calls `row(group, index)` for each question of a function that can be known beforehand, and joins what it returns.
template <typename Row>
std::string table(Function function, std::string const& unknown, Row const& row)
{
    Rubric const rubric = read_rubric(installation().rubric);
    std::string rows;
    for (auto const& group : make_questions(rubric, FunctionSet::only(function), default_seed).request.groups)
        for (std::uint32_t i = 0; group.name != unknown && i < group.count; ++i)
            rows += row(group, i);
    return rows;
}

std::string repeat_row(Group const& group, std::uint32_t i)
{
    auto const q = question<WrapQuestion>(group, i);
    return fmt::format("{{{{{}, {}}}, {}}},\n", q.val, q.size, (q.val % q.size + q.size) % q.size);
}

std::string position_row(Group const& group, std::uint32_t i)
{
    auto const q = question<TransformQuestion>(group, i);
    glm::dvec3 const right(dmat4(q.matrix) * glm::dvec4(dvec3(q.vector), 1));
    return fmt::format("{{{{{{{:a}f, {:a}f, {:a}f}}}}, {{{:a}f, {:a}f, {:a}f}}}},\n", q.vector[0], q.vector[1],
                       q.vector[2], float(right.x), float(right.y), float(right.z));
}

Json grade_function(Function function, std::string const& patch)
{
    Graded const graded =
        grade_text(patched_reference(patch), {"--lenient", "--tasks", std::string(1, info(function).task)});
    return graded.report.at("functions").at(std::string(info(function).name));
}

std::set<std::string> failed_checks(Json const& function)
{
    std::set<std::string> failed;
    for (auto const& c : function.at("checks"))
        if (!c.at("passed").get<bool>())
            failed.insert(c.at("name"));
    return failed;
}

/// The check fails, and costs everything.
void expect_found_out(Function function, std::string const& patch, std::string const& check)
{
    Json const found = grade_function(function, patch);
    EXPECT_EQ(found.at("earned"), 0);
    EXPECT_EQ(failed_checks(found).count(check), 1u);
}

/// Its answers to what is not in the table `rows`.
std::string wrap_repeat_with(std::string const& rows, std::string const& otherwise)
{
    return R"(#include <map>
int ImageTexture::wrap_repeat(int val, int size)
{
    static std::map<std::pair<int, int>, int> const known = {
)" + rows + R"(};
    auto const found = known.find({val, size});
    return found == known.end() ? )" +
           otherwise + R"( : found->second;
}
)";
}

std::string bilinear_row(Textures const& textures, Group const& group, std::uint32_t i)
{
    auto const q = question<LookupQuestion>(group, i);
    glm::dvec4 const c = bilinear(textures[q.texture], q.level, dvec2(q.uv)).value;
    return fmt::format("{{{{{}, {:a}f, {:a}f, {:a}f}}, {{{:a}f, {:a}f, {:a}f, {:a}f}}}},\n", q.level, q.uv[0], q.uv[1],
                       textures[q.texture].levels[0].texels[0], c.r, c.g, c.b, c.a);
}

/// Without the half-texel shift, but for what is in the table.
std::string bilinear_with(std::string const& rows)
{
    return R"(#include <array>
#include <map>
glm::vec4 ImageTexture::evaluate_bilinear(int level, glm::vec2 const& uv) const
{
    static std::map<std::array<float, 4>, glm::vec4> const known = {
)" + rows + R"(};
    auto const found = known.find({float(level), uv.x, uv.y, mip_levels[0]->getPixel(0, 0).r});
    if (found != known.end())
        return found->second;
    Image const& image = *mip_levels[level];
    glm::vec2 const st = uv * glm::vec2(image.getWidth(), image.getHeight());
    int const x = int(std::floor(st.x));
    int const y = int(std::floor(st.y));
    return glm::mix(glm::mix(get_texel(level, x, y), get_texel(level, x + 1, y), st.x - x),
                    glm::mix(get_texel(level, x, y + 1), get_texel(level, x + 1, y + 1), st.x - x), st.y - y);
}
)";
}
}  // namespace

TEST(HardCodedAnswers, OfWrapRepeatEarnNothing)
{
    std::string const check = "WrapRepeat.WholePeriods";
    std::string const rows = table(Function::wrap_repeat, check, repeat_row);
    expect_found_out(Function::wrap_repeat, wrap_repeat_with(rows, "std::min(std::max(val, 0), size - 1)"), check);
}

/// Where a function is wrong in a part of its questions only, a table of that part gains nothing either.
TEST(HardCodedAnswers, GainNothingBesideAMistakeInWrapRepeat)
{
    std::string const rows = table(Function::wrap_repeat, "WrapRepeat.WholePeriods", repeat_row);
    for (auto const& known : {std::string("{{0, 1}, 0}"), rows})
        EXPECT_EQ(grade_function(Function::wrap_repeat, wrap_repeat_with(known, "std::abs(val % size)")).at("earned"),
                  0.5);
}

TEST(HardCodedAnswers, GainNothingBesideAMistakeInBilinear)
{
    Textures const textures = make_test_textures(default_seed);
    std::string const rows =
        table(Function::evaluate_bilinear, "EvaluateBilinear.LinearInTheTexture",
              [&](Group const& group, std::uint32_t i) { return bilinear_row(textures, group, i); });
    Json const without = grade_function(Function::evaluate_bilinear, bilinear_with(""));
    Json const with = grade_function(Function::evaluate_bilinear, bilinear_with(rows));
    EXPECT_EQ(without.at("earned"), 2);
    EXPECT_EQ(with.at("earned"), 2);
    EXPECT_EQ(failed_checks(with), failed_checks(without));
}

TEST(HardCodedAnswers, OfTransformPositionEarnNothing)
{
    std::string const check = "TransformPosition.MovedMatrix";
    std::string const upload = R"(#include <array>
#include <map>
glm::vec3 transform_position(glm::mat4 const&, glm::vec3 const& p)
{
    static std::map<std::array<float, 3>, glm::vec3> const known = {
)" + table(Function::transform_position, check, position_row) +
                               R"(};
    auto const found = known.find({p.x, p.y, p.z});
    return found == known.end() ? p : found->second;
}
)";
    expect_found_out(Function::transform_position, upload, check);
}

TEST(HardCodedAnswers, OfTheCorpusEarnNothing)
{
    std::string const file = read_file(TESTAT_TABLE_UPLOAD);
    expect_found_out(Function::create_mipmap, file.substr(file.find('\n') + 1), "CreateMipmap.LinearInTheTexture");
}
}  // namespace testat
