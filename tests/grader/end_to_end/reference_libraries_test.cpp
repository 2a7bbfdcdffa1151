// The library that stands around a function under test must not hold a working copy of it.
#include <cglib/rt/texture_access.h>
#include "probe/slots.h"

#include <cglib/rt/object.h>
#include <cglib/rt/raytracing_context.h>
#include <cglib/rt/transform.h>

#include <gtest/gtest.h>

#include <csignal>

namespace testat {
namespace {
/// Two levels, enough for every look-up.
ImageTexture make_texture()
{
    ImageTexture texture(Image(2, 2), NEAREST, REPEAT);
    TextureAccess::levels(texture).push_back(std::make_shared<Image>(1, 1));
    return texture;
}

Ray const down(glm::vec3(0, 1, 0), glm::vec3(0, -1, 0));

void intersect_plane_object()
{
    RaytracingContext context;
    RaytracingContext::Activation const activation(context);
    Intersection isect;
    create_plane(glm::vec3(0), glm::vec3(0, 1, 0))->intersect(down, &isect);
}

void measure_footprint()
{
    Ray const rays[4] = {down, down, down, down};
    Intersection isect;
    isect.position = glm::vec3(0);
    isect.normal = glm::vec3(0, 1, 0);
    create_plane(glm::vec3(0), glm::vec3(0, 1, 0))->compute_uv_aabb_size(rays, isect);
}

/// Calls a function of the sheet the way the framework does.
void call(Function function)
{
    switch (function) {
        case Function::evaluate_nearest:
            make_texture().evaluate_nearest(0, glm::vec2(0));
            return;
        case Function::wrap_clamp:
            ImageTexture::wrap_clamp(0, 1);
            return;
        case Function::wrap_repeat:
            ImageTexture::wrap_repeat(0, 1);
            return;
        case Function::evaluate_bilinear:
            make_texture().evaluate_bilinear(0, glm::vec2(0));
            return;
        case Function::create_mipmap:
            make_texture().create_mipmap();
            return;
        case Function::compute_uv_aabb_size:
            measure_footprint();
            return;
        case Function::evaluate_trilinear:
            make_texture().evaluate_trilinear(glm::vec2(0), glm::vec2(1));
            return;
        case Function::transform_direction:
            transform_direction(glm::mat4(1), glm::vec3(1));
            return;
        case Function::transform_position:
            transform_position(glm::mat4(1), glm::vec3(1));
            return;
        case Function::intersect:
            intersect_plane_object();
            return;
        case Function::transform_direction_to_object_space:
            transform_direction_to_object_space({0, 1, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1});
            return;
    }
}

/// Runs in a process of its own, as slots are global.
[[noreturn]] void call_with(std::string const& library, Function function)
{
    fill_slots(load_library(std::string(TESTAT_REFERENCES) + "/" + library + ".so"), FunctionSet::all());
    call(function);
    std::_Exit(0);
}

class WithoutFunction : public testing::TestWithParam<Function> {};

TEST_P(WithoutFunction, AbortsThere)
{
    std::string const library = "without_" + std::string(info(GetParam()).name);
    EXPECT_EXIT(call_with(library, GetParam()), testing::KilledBySignal(SIGABRT), "");
}

TEST_P(WithoutFunction, AnswersEverywhereElse)
{
    std::string const library = "without_" + std::string(info(GetParam()).name);
    auto const calls_no_other = Function::transform_direction_to_object_space;
    Function const other = GetParam() == calls_no_other ? Function::wrap_clamp : calls_no_other;
    EXPECT_EXIT(call_with(library, other), testing::ExitedWithCode(0), "");
}

TEST_P(WithoutFunction, IsWholeInTheReference)
{
    EXPECT_EXIT(call_with("all", GetParam()), testing::ExitedWithCode(0), "");
}

INSTANTIATE_TEST_SUITE_P(References, WithoutFunction, testing::ValuesIn(every_function()),
                         [](auto const& p) { return std::string(testat::info(p.param).name); });
}  // namespace
}  // namespace testat
