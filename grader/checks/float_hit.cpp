#include "checks/float_hit.h"

#include <algorithm>

namespace testat {
namespace {
Certainty both(Certainty a, Certainty b)
{
    return std::min(a, b);
}

FloatHit hit_at(Certainty hit, Rounded t, RoundedLine const& ray)
{
    return {hit, t, ray.origin + t * ray.direction, {}};
}

FloatHit meet_sphere(Shape const& sphere, RoundedLine const& ray)
{
    RoundedVector const center = exact_vector(sphere.center);
    Rounded const radius = sphere.radius;
    Rounded const a = dot(ray.direction, ray.direction);
    RoundedVector const to_origin = ray.origin - center;
    Rounded const middle = -dot(to_origin, ray.direction) / a;
    RoundedVector const nearest = to_origin + middle * ray.direction;
    Rounded const half_chord_squared = (radius * radius - dot(nearest, nearest)) / a;
    Rounded const half_chord = sqrt(half_chord_squared);
    Rounded const first = middle - half_chord;
    Rounded const second = middle + half_chord;
    // Where the first of the two is ahead only perhaps, they are too far apart to call either right.
    Certainty const line = is_positive(half_chord_squared);
    Certainty const outside = is_positive(first);
    Certainty const ahead = is_positive(second);
    bool const which = outside == Certainty::perhaps && ahead != Certainty::no && line != Certainty::no;
    FloatHit hit =
        hit_at(which ? Certainty::perhaps : both(line, ahead), outside == Certainty::yes ? first : second, ray);
    hit.normal = normalize(hit.position - center);
    return hit;
}

/// Exactly parallel is a miss; nearly parallel is anything.
FloatHit meet_plane(RoundedVector const& center, RoundedVector const& normal, RoundedLine const& ray)
{
    Rounded const speed = dot(ray.direction, normal);
    if (speed.value == 0 && speed.error == 0)
        return {};
    Rounded const t = dot(center - ray.origin, normal) / speed;
    FloatHit hit = hit_at(is_positive(t), t, ray);
    hit.normal = normal;
    return hit;
}

Certainty is_between_0_and_1(Rounded x)
{
    return both(is_positive(x), is_positive(1 - x));
}

FloatHit meet_quad(Shape const& quad, RoundedLine const& ray)
{
    RoundedVector const center = exact_vector(quad.center);
    RoundedVector const e0 = exact_vector(quad.a);
    RoundedVector const e1 = exact_vector(quad.b);
    RoundedVector const normal = normalize(cross(e0, e1));
    FloatHit hit = meet_plane(center, normal, ray);
    if (hit.hit == Certainty::no)
        return hit;
    RoundedVector const d = hit.position - center;
    Rounded const area = length(cross(e0, e1));
    Rounded const a = dot(cross(d, e1), normal) / area + 0.5;
    Rounded const b = dot(cross(e0, d), normal) / area + 0.5;
    hit.hit = both(hit.hit, both(is_between_0_and_1(a), is_between_0_and_1(b)));
    return hit;
}
}  // namespace

FloatHit meet(Shape const& shape, RoundedLine const& ray)
{
    switch (shape.kind) {
        case ShapeKind::sphere:
            return meet_sphere(shape, ray);
        case ShapeKind::plane:
            return meet_plane(exact_vector(shape.center), normalize(exact_vector(shape.a)), ray);
        default:
            return meet_quad(shape, ray);
    }
}
}  // namespace testat
