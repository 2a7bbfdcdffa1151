#include "checks/float_hit.h"
#include "checks/matrices.h"
#include "checks/oracles.h"
#include "checks/relations.h"
#include "checks/shapes.h"

#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>

namespace testat {
namespace {
constexpr int questions_each = 256;

Shape random_shape(Random& random)
{
    glm::dmat3 const frame(random_rotation(random));
    glm::dvec3 const center = random_vector(random, 2);
    switch (random.integer(0, 2)) {
        case 0:
            return make_sphere(center, random.uniform(0.5, 2), 1);
        case 1:
            return make_plane(center, frame[1], frame[0], 1);
        default:
            return make_quad(center, frame[0] * random.uniform(1, 4), frame[2] * random.uniform(1, 4));
    }
}

/// Translation, rotation, a scale of its own for each axis, and a mirror every other time.
glm::dmat4 random_transform(Random& random)
{
    glm::dmat4 const moved = glm::translate(glm::dmat4(1), random_vector(random, 5)) * random_rotation(random);
    return glm::scale(moved, random_scale(random) * glm::dvec3(random.coin() ? -1 : 1, 1, 1));
}

/// A point in object space that a ray can be aimed at: on the shape, or clearly beside it.
glm::dvec3 random_target(Random& random, Shape const& shape, bool hit)
{
    glm::dvec3 const center = dvec3(shape.center);
    if (shape.kind == ShapeKind::sphere)
        return center + random_direction(random) * double(shape.radius) * (hit ? 0.7 : 1.0);
    double const reach = shape.kind == ShapeKind::quad ? (hit ? 0.4 : 0.9) : 2;
    double const side = hit ? random.uniform(-reach, reach) : (random.coin() ? reach : -reach);
    glm::dvec3 const a = shape.kind == ShapeKind::plane ? glm::cross(dvec3(shape.a), dvec3(shape.b)) : dvec3(shape.a);
    return center + side * a + random.uniform(-reach, reach) * dvec3(shape.b);
}

/// Aims so that a hit is no graze and a miss is no near one.
Line aim(Random& random, Shape const& shape, bool hit)
{
    for (;;) {
        glm::dvec3 const target = random_target(random, shape, hit);
        glm::dvec3 direction = random_direction(random);
        if (!hit && shape.kind == ShapeKind::sphere)  // perpendicular to the radius, half a radius outside
            direction = glm::normalize(glm::cross(direction, target - dvec3(shape.center)));
        glm::dvec3 const outside =
            !hit && shape.kind == ShapeKind::sphere ? 0.5 * (target - dvec3(shape.center)) : glm::dvec3(0);
        Line ray{target + outside - direction * random.uniform(3, 10), direction};
        if (!hit && shape.kind == ShapeKind::plane)
            ray = {target - direction * 3.0, -direction};
        auto const met = meet(shape, ray);
        if (met.has_value() == hit && (!hit || (met->cosine > 0.3 && met->t > 0.5)))
            return ray;
    }
}

/// From inside a sphere: the far side is hit.
Line aim_from_inside(Random& random, Shape const& sphere)
{
    return {dvec3(sphere.center) + random_direction(random) * double(sphere.radius) * 0.6, random_direction(random)};
}

IntersectQuestion make_question(Shape const& shape, glm::dmat4 const& object_to_world, Line const& object_ray)
{
    IntersectQuestion q{};
    q.shape = shape;
    q.transform_objects = 1;
    store(object_to_world, q.object_to_world);
    store(glm::dvec3(object_to_world * glm::dvec4(object_ray.origin, 1)), q.origin);
    store(glm::normalize(glm::dvec3(object_to_world * glm::dvec4(object_ray.direction, 0))), q.direction);
    return q;
}

/// Exactly along an axis of the world, so that two components of the direction are zero.
IntersectQuestion ask_hit_along_axis(Random& random)
{
    glm::dvec3 axis(0);
    axis[random.integer(0, 2)] = random.coin() ? -1 : 1;
    for (;;) {
        Shape const shape = random_shape(random);
        glm::dmat4 const transform = random_transform(random);
        glm::dvec3 const direction = glm::normalize(glm::inverse(glm::dmat3(transform)) * axis);
        glm::dvec3 const target = random_target(random, shape, true);
        Line const ray{target - direction * random.uniform(3, 10), direction};
        auto const met = meet(shape, ray);
        if (!met || !(met->cosine > 0.3 && met->t > 0.5))
            continue;
        IntersectQuestion q = make_question(shape, transform, ray);
        store(axis, q.direction);
        return q;
    }
}

IntersectQuestion ask_hit(Random& random)
{
    if (random.integer(0, 7) == 0)
        return ask_hit_along_axis(random);
    Shape const shape = random_shape(random);
    bool const inside = shape.kind == ShapeKind::sphere && random.integer(0, 3) == 0;
    return make_question(shape, random_transform(random),
                         inside ? aim_from_inside(random, shape) : aim(random, shape, true));
}

/// At a distance of half a thousandth, or of some thousand, in the world. Not of spheres: of one so far away a float
/// says neither hit nor miss.
IntersectQuestion ask_near_or_far_hit(Random& random)
{
    double const t = random.coin() ? 5e-4 : random.uniform(2e3, 1e4);
    for (;;) {
        Shape const shape = random_shape(random);
        glm::dmat4 const transform = random_transform(random);
        glm::dvec3 const direction = random_direction(random);
        double const in_object_space = t / glm::length(glm::dmat3(transform) * direction);
        Line const ray{random_target(random, shape, true) - direction * in_object_space, direction};
        auto const met = shape.kind == ShapeKind::sphere ? std::nullopt : meet(shape, ray);
        if (met && met->cosine > 0.3)
            return make_question(shape, transform, ray);
    }
}

IntersectQuestion ask_hit_at_any_distance(Random& random)
{
    return random.integer(0, 7) == 0 ? ask_near_or_far_hit(random) : ask_hit(random);
}

IntersectQuestion ask_hit_or_miss(Random& random)
{
    Shape const shape = random_shape(random);
    glm::dmat4 const transform = random_transform(random);
    return make_question(shape, transform, aim(random, shape, random.coin()));
}

/// The matrix is there but must not be used.
IntersectQuestion ask_untransformed(Random& random)
{
    Shape const shape = random_shape(random);
    IntersectQuestion q = make_question(shape, glm::dmat4(1), aim(random, shape, random.coin()));
    store(random_transform(random), q.object_to_world);
    q.transform_objects = 0;
    return q;
}

auto ask(IntersectQuestion (*make)(Random&))
{
    return [=](Random& random, Textures const&) {
        std::vector<IntersectQuestion> questions;
        for (int i = 0; i < questions_each; ++i)
            questions.push_back(make(random));
        return make_group(Kind::intersect, questions);
    };
}

/// What is right in world space.
struct WorldHit {
    Certainty hit;
    RoundedVector position;
    RoundedVector normal;
    Rounded t;

    bool is_decided() const
    {
        return hit != Certainty::perhaps && std::isfinite(position.error() + normal.error() + t.error);
    }
};

/// The distance by length of the difference, or as the object's t scaled by how the matrix or its inverse stretches the
/// direction: all are right, so the least accurate counts.
Rounded distance(RoundedLine const& world, RoundedVector const& position, RoundedTransform const& to_world,
                 RoundedTransform const& to_object, RoundedLine const& object, Rounded t)
{
    Rounded const by_length = length(position - world.origin);
    Rounded const by_scale = t * length(times_direction(to_world, object.direction));
    Rounded const by_inverse = t / length(times_direction(to_object, world.direction));
    return {by_length.value, std::max({by_length.error, by_scale.error, by_inverse.error})};
}

/// As the framework does it, step by step: the matrix is inverted, the ray transformed, the shape met, and what was met
/// transformed back. Rays normalise their direction, which transform_direction has done already.
WorldHit meet_in_world(IntersectQuestion const& q)
{
    RoundedLine const world{exact_vector(q.origin), normalize(exact_vector(q.direction))};
    if (q.transform_objects == 0) {
        FloatHit const met = meet(q.shape, world);
        return {met.hit, met.position, met.normal, met.t};
    }
    RoundedTransform const to_world = exact_transform(q.object_to_world);
    RoundedTransform const to_object = inverse(to_world);
    RoundedLine const object{times_position(to_object, world.origin),
                             normalize(normalize(times_direction(to_object, world.direction)))};
    FloatHit const met = meet(q.shape, object);
    if (met.hit != Certainty::yes)
        return {met.hit, {}, {}, {}};
    RoundedVector const position = times_position(to_world, met.position);
    RoundedVector const normal = normalize(times_direction(transpose(to_object), met.normal));
    return {met.hit, position, normal, distance(world, position, to_world, to_object, object, met.t)};
}

Deviation compare_hit(Answers const& answers, std::uint32_t i, Certainty hit)
{
    int const measured = integer(answers, i);
    bool const right = hit == Certainty::perhaps ? measured == 0 || measured == 1 : measured == (hit == Certainty::yes);
    return {right ? 0 : HUGE_VAL, measured == 1 ? "true" : "false", hit == Certainty::no ? "false" : "true"};
}

/// One component or three, from a word of the answer on; the bound is the same for all.
template <std::size_t size>
Deviation compare_part(Answers const& answers, std::uint32_t i, std::size_t word, std::vector<double> const& right,
                       double bound, char const* name, Words words)
{
    auto const measured = floats<size>(answers, i, word);
    Deviation d = compare({measured.begin(), measured.end()}, right, std::vector<double>(size, bound), words);
    if (d.measured.empty())
        return d;
    d.measured = fmt::format("isect->{} = {}", name, d.measured);
    d.expected = fmt::format("isect->{} = {}", name, d.expected);
    return d;
}

std::vector<double> list(RoundedVector const& v)
{
    return {v.x.value, v.y.value, v.z.value};
}

Deviation compare_distance(Answers const& answers, std::uint32_t i, WorldHit const& right, Words words)
{
    return compare_part<1>(answers, i, 1, {right.t.value}, right.t.error, "t", words);
}

Deviation compare_place(Answers const& answers, std::uint32_t i, WorldHit const& right, Words words)
{
    auto const part = [&](std::size_t word, RoundedVector const& v, char const* name) {
        return compare_part<3>(answers, i, word, list(v), v.error(), name, words);
    };
    return worst_of({part(2, right.position, "position"), part(5, right.normal, "normal"),
                     part(8, right.normal, "geometric_normal")});
}

/// A scene, and the same moved, rotated and scaled as a whole with its ray.
struct MovedScene {
    std::array<IntersectQuestion, 2> questions;
};

MovedScene move_scene(Random& random, Textures const&)
{
    Shape const shape = random_shape(random);
    glm::dmat4 const transform = random_transform(random);
    Line const ray = aim(random, shape, random.coin());
    glm::dmat4 const moved = glm::translate(glm::dmat4(1), random_vector(random, 5)) * random_rotation(random);
    glm::dmat4 const scaled = glm::scale(moved, glm::dvec3(random.coin() ? 2 : 0.5));
    return {{make_question(shape, transform, ray), make_question(shape, scaled * transform, ray)}};
}

/// Rays are no near misses and no grazes, so float hits where double does.
Deviation compare_hits(Answers const& answers, MovedScene const&, std::array<std::uint32_t, 2> const& places)
{
    Deviation deviation =
        compare_hit(answers, places[1], integer(answers, places[0]) == 1 ? Certainty::yes : Certainty::no);
    deviation.measured += ", before it was moved: " + deviation.expected;
    return deviation;
}

/// Half of the rays hit, give or take a few.
Deviation both_hits_and_misses(Answers const& answers, std::vector<std::uint32_t> const& places)
{
    auto const hits = std::size_t(
        std::count_if(places.begin(), places.end(), [&](std::uint32_t place) { return integer(answers, place) == 1; }));
    bool const both = 8 * hits > places.size() && 8 * hits < 7 * places.size();
    return {both ? 0 : HUGE_VAL, fmt::format("{} of {} rays hit", hits, places.size()), "hits and misses"};
}

/// Where float may come to any answer, a hit is still made of numbers.
Deviation undecided(Answers const& answers, std::uint32_t i, Certainty hit)
{
    Deviation deviation = compare_hit(answers, i, hit);
    deviation.decided = false;
    auto const words = floats<10>(answers, i, 1);
    bool const finite = std::all_of(words.begin(), words.end(), [](float x) { return std::isfinite(x); });
    if (integer(answers, i) == 1 && !finite)
        deviation.in_bounds = HUGE_VAL;
    return deviation;
}

enum class Judged { hit, distance, place, all };

Deviation part_deviation(Judged what, Answers const& answers, std::uint32_t i, Words words)
{
    WorldHit const right = meet_in_world(question<IntersectQuestion>(answers.group, i));
    Deviation hit = compare_hit(answers, i, right.hit);
    if (right.hit != Certainty::no && !right.is_decided())
        return undecided(answers, i, right.hit);
    if (right.hit == Certainty::no || what == Judged::hit || !(hit.in_bounds <= 1))
        return hit;
    if (what == Judged::distance)
        return compare_distance(answers, i, right, words);
    Deviation const place = compare_place(answers, i, right, words);
    return what == Judged::place ? place : worst_of({place, compare_distance(answers, i, right, words)});
}

template <Judged what>
Deviation deviation(Answers const& answers, std::uint32_t i, Textures const&, Words words)
{
    return part_deviation(what, answers, i, words);
}
}  // namespace

Deviation intersect_deviation(Answers const& answers, std::uint32_t index, Textures const&, Words words)
{
    return part_deviation(Judged::all, answers, index, words);
}

void add_intersect_checks(std::vector<UnitCheck>& checks)
{
    auto const add = [&](char const* name, auto make, Oracle oracle) {
        checks.push_back({std::string("Intersect.") + name, Function::intersect, ask(make), judge_by(oracle)});
    };
    add("HitsAndMisses", ask_hit_or_miss, deviation<Judged::hit>);
    add("DistanceInTheWorld", ask_hit_at_any_distance, deviation<Judged::distance>);
    add("PlaceInTheWorld", ask_hit, deviation<Judged::place>);
    add("TransformsOff", ask_untransformed, intersect_deviation);
    checks.push_back(metamorphic_check("Intersect.MovedScene", Function::intersect, Kind::intersect, move_scene,
                                       compare_hits, both_hits_and_misses));
}
}  // namespace testat
