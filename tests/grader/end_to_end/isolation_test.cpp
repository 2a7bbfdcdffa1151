// Canaries: each fails if a function is no longer judged alone.
#include "end_to_end/testat_program.h"

#include "functions.h"
#include "source/definitions.h"

#include <gtest/gtest.h>

#include <tuple>

namespace testat {
namespace {
std::string compiler_name(std::string const& compiler)
{
    return compiler == "g++" ? "gcc" : "clang";
}

/// The reference, with every function but one aborting.
std::string aborting_but(Function function)
{
    std::string text = "#include <cstdlib>\n" + reference_text();
    for (Function f : every_function())
        if (f != function)
            text = replace_body(text, f, "{ std::abort(); }");
    return text;
}

class Isolation : public testing::TestWithParam<std::tuple<Function, std::string>> {};

TEST_P(Isolation, KeepsOtherFunctionsOut)
{
    auto const [function, compiler] = GetParam();
    std::string const task(1, info(function).task);
    Graded const graded = grade_text(aborting_but(function), {"--compiler", compiler, "--tasks", task});
    Json const& part = graded.report.at("functions").at(std::string(info(function).name));
    EXPECT_EQ(part.at("verdict"), "correct") << function_table_of(graded.report);
    EXPECT_EQ(part.at("earned"), part.at("max"));
    for (auto const& check : part.at("checks"))
        EXPECT_TRUE(check.at("passed").get<bool>()) << check;
}

INSTANTIATE_TEST_SUITE_P(Functions, Isolation,
                         testing::Combine(testing::ValuesIn(every_function()), testing::ValuesIn(compilers())),
                         [](auto const& p) {
                             return std::string(testat::info(std::get<0>(p.param)).name) + "_" +
                                    compiler_name(std::get<1>(p.param));
                         });

/// Every function asks itself, keeping some of the stack each time. If a call under test ended anywhere but in the
/// upload, it would come back with the right answer.
std::string const asking_themselves = R"(
namespace
{
struct Frame
{
    volatile char bytes[8192];
    Frame() { bytes[0] = 0; }
    ~Frame() { bytes[1] = bytes[0]; }
};
}  // namespace

glm::vec4 ImageTexture::evaluate_nearest(int level, glm::vec2 const& uv) const
{
    Frame const frame;
    return evaluate_nearest(level, uv);
}

int ImageTexture::wrap_clamp(int val, int size)
{
    Frame const frame;
    return wrap_clamp(val, size);
}

int ImageTexture::wrap_repeat(int val, int size)
{
    Frame const frame;
    return wrap_repeat(val, size);
}

glm::vec4 ImageTexture::evaluate_bilinear(int level, glm::vec2 const& uv) const
{
    Frame const frame;
    return evaluate_bilinear(level, uv);
}

void ImageTexture::create_mipmap()
{
    Frame const frame;
    create_mipmap();
}

glm::vec2 Object::compute_uv_aabb_size(const Ray rays[4], Intersection const& isect)
{
    Frame const frame;
    return compute_uv_aabb_size(rays, isect);
}

glm::vec4 ImageTexture::evaluate_trilinear(glm::vec2 const& uv, glm::vec2 const& dudv) const
{
    Frame const frame;
    return evaluate_trilinear(uv, dudv);
}

glm::vec3 transform_direction(glm::mat4 const& transform, glm::vec3 const& d)
{
    Frame const frame;
    return transform_direction(transform, d);
}

glm::vec3 transform_position(glm::mat4 const& transform, glm::vec3 const& p)
{
    Frame const frame;
    return transform_position(transform, p);
}

bool Object::intersect(Ray const& ray, Intersection* isect) const
{
    Frame const frame;
    return intersect(ray, isect);
}

glm::vec3 transform_direction_to_object_space(glm::vec3 const& d, glm::vec3 const& normal, glm::vec3 const& tangent,
                                              glm::vec3 const& bitangent)
{
    Frame const frame;
    return transform_direction_to_object_space(d, normal, tangent, bitangent);
}
)";

class NoCopy : public testing::TestWithParam<std::string> {};

TEST_P(NoCopy, OfTheFunctionUnderTestCanBeCalled)
{
    Graded const graded = grade_text(patched_reference(asking_themselves), {"--compiler", GetParam()});
    for (auto const& [name, function] : graded.report.at("functions").items()) {
        EXPECT_EQ(function.at("verdict"), "crashed") << name;
        for (auto const& check : function.at("checks"))
            EXPECT_FALSE(check.at("passed").get<bool>()) << check;
    }
}

INSTANTIATE_TEST_SUITE_P(Compilers, NoCopy, testing::ValuesIn(compilers()),
                         [](auto const& p) { return compiler_name(p.param); });
}  // namespace
}  // namespace testat
