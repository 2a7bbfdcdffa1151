// Files that know what the default seed asks and answer from a table: right there, and nowhere else.
#include "answers.h"
#include "checks/run_checks.h"
#include "checks/vectors.h"
#include "end_to_end/testat_program.h"
#include "installation.h"
#include "rubric/rubric.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

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

/// The function's only failure is that check, and it costs everything.
void expect_found_out(Function function, std::string const& patch, std::string const& check)
{
    Graded const graded =
        grade_text(patched_reference(patch), {"--lenient", "--tasks", std::string(1, info(function).task)});
    Json const& found = graded.report.at("functions").at(std::string(info(function).name));
    EXPECT_EQ(found.at("earned"), 0);
    for (auto const& c : found.at("checks"))
        EXPECT_EQ(c.at("passed").get<bool>(), c.at("name") != check) << c;
}
}  // namespace

TEST(HardCodedAnswers, OfWrapRepeatEarnNothing)
{
    std::string const check = "WrapRepeat.WholePeriods";
    std::string const upload = R"(#include <map>
int ImageTexture::wrap_repeat(int val, int size)
{
    static std::map<std::pair<int, int>, int> const known = {
)" + table(Function::wrap_repeat, check, repeat_row) +
                               R"(};
    auto const found = known.find({val, size});
    return found == known.end() ? std::min(std::max(val, 0), size - 1) : found->second;
}
)";
    expect_found_out(Function::wrap_repeat, upload, check);
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

/// If this fails because other checks do, the textures of the default seed have changed: put theirs into the file.
TEST(HardCodedAnswers, OfTheCorpusAreUpToDate)
{
    std::string const file = read_file(TESTAT_TABLE_UPLOAD);
    expect_found_out(Function::create_mipmap, file.substr(file.find('\n') + 1), "CreateMipmap.LinearInTheTexture");
}
}  // namespace testat
