#include "checks/shapes.h"

#include <cmath>

namespace testat {
namespace {
constexpr double pi = 3.14159265358979323846;

std::optional<Hit> at(Line const& ray, double t, glm::dvec3 normal)
{
    return Hit{t, ray.origin + t * ray.direction, normal, std::abs(glm::dot(ray.direction, normal))};
}

std::optional<Hit> meet_sphere(Shape const& sphere, Line const& ray)
{
    glm::dvec3 const center = dvec3(sphere.center);
    double const radius = sphere.radius;
    glm::dvec3 const offset = ray.origin - center;
    double const b = glm::dot(offset, ray.direction);
    double const c = glm::dot(offset, offset) - radius * radius;
    if (!(b * b - c >= 0))
        return std::nullopt;
    double const root = std::sqrt(b * b - c);
    double const t = -b - root > 0 ? -b - root : -b + root;
    if (!(t > 0))
        return std::nullopt;
    return at(ray, t, (offset + t * ray.direction) / radius);
}

std::optional<Hit> meet_flat(Shape const& shape, glm::dvec3 normal, Line const& ray)
{
    auto const t = meet_plane(dvec3(shape.center), normal, ray);
    return t ? at(ray, *t, normal) : std::nullopt;
}

/// Coordinates along e0 and e1 are found by Cramer's rule in the quad's plane.
std::optional<Hit> meet_quad(Shape const& quad, Line const& ray)
{
    glm::dvec3 const e0 = dvec3(quad.a);
    glm::dvec3 const e1 = dvec3(quad.b);
    glm::dvec3 const cross = glm::cross(e0, e1);
    auto const hit = meet_flat(quad, glm::normalize(cross), ray);
    if (!hit)
        return std::nullopt;
    glm::dvec3 const d = hit->position - dvec3(quad.center);
    double const u = glm::dot(glm::cross(d, e1), cross) / glm::dot(cross, cross);
    double const v = glm::dot(glm::cross(e0, d), cross) / glm::dot(cross, cross);
    bool const inside = std::abs(u) <= 0.5 && std::abs(v) <= 0.5;
    return inside ? hit : std::nullopt;
}

Shape shape_of(ShapeKind kind, glm::dvec3 center, double scale_uv)
{
    Shape shape{};
    shape.kind = kind;
    shape.scale_uv = static_cast<float>(scale_uv);
    store(center, shape.center);
    return shape;
}
}  // namespace

std::optional<double> meet_plane(glm::dvec3 point, glm::dvec3 normal, Line const& ray)
{
    double const slope = glm::dot(ray.direction, normal);
    double const t = glm::dot(point - ray.origin, normal) / slope;
    if (slope == 0 || !(t > 0))
        return std::nullopt;
    return t;
}

std::optional<Hit> meet(Shape const& shape, Line const& ray)
{
    switch (shape.kind) {
        case ShapeKind::sphere:
            return meet_sphere(shape, ray);
        case ShapeKind::plane:
            return meet_flat(shape, glm::normalize(dvec3(shape.a)), ray);
        default:
            return meet_quad(shape, ray);
    }
}

glm::dvec2 map_uv(Shape const& shape, glm::dvec3 position)
{
    glm::dvec3 const d = position - dvec3(shape.center);
    double const scale = shape.scale_uv;
    if (shape.kind == ShapeKind::plane) {
        glm::dvec3 const tangent = dvec3(shape.b);
        return glm::dvec2(glm::dot(d, tangent), glm::dot(d, glm::cross(tangent, dvec3(shape.a)))) / scale;
    }
    glm::dvec3 const n = glm::normalize(d);
    double const u = std::atan2(-n.z, n.x) / (2 * pi);
    return scale * glm::dvec2(u < 0 ? u + 1 : u, 1 - std::acos(n.y) / pi);
}

Shape make_sphere(glm::dvec3 center, double radius, double scale_uv)
{
    Shape shape = shape_of(ShapeKind::sphere, center, scale_uv);
    shape.radius = static_cast<float>(radius);
    return shape;
}

Shape make_plane(glm::dvec3 center, glm::dvec3 normal, glm::dvec3 tangent, double scale_uv)
{
    Shape shape = shape_of(ShapeKind::plane, center, scale_uv);
    store(normal, shape.a);
    store(tangent, shape.b);
    return shape;
}

Shape make_quad(glm::dvec3 center, glm::dvec3 e0, glm::dvec3 e1)
{
    Shape shape = shape_of(ShapeKind::quad, center, 1);
    store(e0, shape.a);
    store(e1, shape.b);
    return shape;
}
}  // namespace testat
