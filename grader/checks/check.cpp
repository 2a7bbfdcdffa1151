#include "checks/check.h"

#include "checks/relations.h"
#include "checks/vectors.h"

#include <fmt/format.h>

#include <algorithm>

namespace testat {
namespace {
std::string number(double value)
{
    return fmt::format("{:.7g}", value);
}

std::string vector(float const* v, std::size_t size)
{
    return format_vector(std::vector<double>(v, v + size));
}

std::string describe(WrapQuestion const& q)
{
    return fmt::format("val = {}, size = {}", q.val, q.size);
}

std::string size_of(TextureData const& texture)
{
    glm::ivec2 const size = level_size(texture, 0);
    return fmt::format("W x H = {} x {}", size.x, size.y);
}

std::string describe(LookupQuestion const& q, Function function, TextureData const& texture)
{
    std::string const uv = "uv = " + vector(q.uv, 2);
    if (function == Function::evaluate_trilinear)
        return fmt::format("{}, {}, dudv = {}", size_of(texture), uv, vector(q.dudv, 2));
    return fmt::format("{}, level = {}, {}", size_of(texture), q.level, uv);
}

std::string describe(Shape const& shape)
{
    std::string const center = vector(shape.center, 3);
    switch (shape.kind) {
        case ShapeKind::sphere:
            return fmt::format("Sphere(center = {}, radius = {})", center, number(shape.radius));
        case ShapeKind::plane:
            return fmt::format("Plane(center = {}, normal = {})", center, vector(shape.a, 3));
        default:
            return fmt::format("Quad(center = {}, e0 = {}, e1 = {})", center, vector(shape.a, 3), vector(shape.b, 3));
    }
}

std::string describe(FootprintQuestion const& q)
{
    std::string directions;
    for (int i = 0; i < 4; ++i)
        directions += fmt::format(", rays[{}].direction = {}", i, vector(q.direction[i], 3));
    return fmt::format("{}, scale_uv = {}, isect.position = {}, rays[0..3].origin = {}{}", describe(q.shape),
                       number(q.shape.scale_uv), vector(q.position, 3), vector(q.origin[0], 3), directions);
}

/// Row by row, as one writes a matrix: [a b c d; e f g h; ...].
std::string describe_matrix(float const* m)
{
    std::string text;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            text += (row + column == 0 ? "[" : column == 0 ? "; " : " ") + number(m[4 * column + row]);
    return text + "]";
}

std::string describe(TransformQuestion const& q, Function function)
{
    char const* name = function == Function::transform_direction ? "d" : "p";
    return fmt::format("transform = {}, {} = {}", describe_matrix(q.matrix), name, vector(q.vector, 3));
}

std::string describe(IntersectQuestion const& q)
{
    return fmt::format(
        "{}, transform_objects = {}, transform_object_to_world = {}, ray.origin = {}, ray.direction = {}",
        describe(q.shape), q.transform_objects != 0, describe_matrix(q.object_to_world), vector(q.origin, 3),
        vector(q.direction, 3));
}

std::string describe(TangentSpaceQuestion const& q)
{
    return fmt::format("d = {}, normal = {}, tangent = {}, bitangent = {}", vector(q.d, 3), vector(q.normal, 3),
                       vector(q.tangent, 3), vector(q.bitangent, 3));
}

double in_bounds(double measured, double expected, double bound)
{
    double const difference = std::abs(measured - expected);
    if (difference == 0)
        return 0;
    return std::isfinite(difference) && bound > 0 ? difference / bound : HUGE_VAL;
}
}  // namespace

std::string format_vector(std::vector<double> const& v)
{
    std::string text;
    for (double x : v)
        text += (text.empty() ? "" : ", ") + number(x);
    return v.size() == 1 ? text : "(" + text + ")";
}

Deviation compare(std::vector<double> const& measured, std::vector<double> const& expected,
                  std::vector<double> const& bound, Words words)
{
    Deviation deviation;
    for (std::size_t i = 0; i < measured.size(); ++i) {
        double const units = in_bounds(measured[i], expected[i], bound[i]);
        if (!(units <= deviation.in_bounds))
            deviation.in_bounds = units;
    }
    if (words == Words::always || !(deviation.in_bounds <= 1)) {
        deviation.measured = format_vector(measured);
        deviation.expected = format_vector(expected);
    }
    return deviation;
}

std::string describe_question(Group const& group, std::uint32_t index, Textures const& textures)
{
    switch (group.kind) {
        case Kind::wrap:
            return describe(question<WrapQuestion>(group, index));
        case Kind::lookup: {
            auto const q = question<LookupQuestion>(group, index);
            return describe(q, group.under_test, textures[q.texture]);
        }
        case Kind::mipmap:
            return size_of(textures[question<MipmapQuestion>(group, index).texture]);
        case Kind::footprint:
            return describe(question<FootprintQuestion>(group, index));
        case Kind::transform:
            return describe(question<TransformQuestion>(group, index), group.under_test);
        case Kind::intersect:
            return describe(question<IntersectQuestion>(group, index));
        case Kind::tangent_space:
            return describe(question<TangentSpaceQuestion>(group, index));
        default:
            return std::string(question<PictureQuestion>(group, index).name);
    }
}

std::vector<UnitCheck> const& unit_checks()
{
    static std::vector<UnitCheck> const all = [] {
        std::vector<UnitCheck> checks;
        add_evaluate_nearest_checks(checks);
        add_wrap_checks(checks);
        add_evaluate_bilinear_checks(checks);
        add_create_mipmap_checks(checks);
        add_compute_uv_aabb_size_checks(checks);
        add_evaluate_trilinear_checks(checks);
        add_transform_checks(checks);
        add_intersect_checks(checks);
        add_tangent_space_checks(checks);
        for (auto& check : checks)
            if (!check.is_metamorphic && check.function != Function::create_mipmap)
                check.ask = twice(check.name, check.ask);
        return checks;
    }();
    return all;
}
}  // namespace testat
