#include "checks/shapes.h"
#include "stress/subjects.h"
#include "stress/wide_matrices.h"

#include <algorithm>

// intersect. Contract: shapes of size 1e-3 to 1e3, a few sizes away from their origin. Affine, invertible matrices of
// scale 1e-12 to 1e12, flattened by 1e3 at most; the framework inverts them by their determinant, which has to be a
// float, and so has its inverse. Translations and distances of up to 1e3 sizes in the world. A distance is measured by
// its square, so a hit is 1e18 away at most: rays nearly along a plane start within 1e6, and have a slope of 1e-9 or
// exactly none.
namespace testat {
namespace {
constexpr double flattest = 1e3;
/// Products of three columns must be floats, and so must their inverses, both in full precision.
constexpr double least_product = 0x1p-125;
constexpr double largest_product = 0x1p125;

Shape any_shape(Random& random, double size)
{
    glm::dmat3 const frame(seldom(random, 4) ? glm::dmat4(1) : random_rotation(random));
    glm::dvec3 const center = seldom(random, 4) ? glm::dvec3(0) : random_vector(random, 3 * size);
    switch (random.integer(0, 2)) {
        case 0:
            return make_sphere(center, size, 1);
        case 1:
            return make_plane(center, frame[1], frame[0], 1);
        default:
            return make_quad(center, frame[0] * size * random.uniform(0.2, 5),
                             (frame[2] + frame[0] * random.uniform(-1, 1)) * size);
    }
}

/// A point on the shape, at its edge, or beside it.
glm::dvec3 any_target(Random& random, Shape const& shape, double size)
{
    glm::dvec3 const center = dvec3(shape.center);
    if (shape.kind == ShapeKind::sphere)
        return center + random_direction(random) * size * random.uniform(0, 1.3);
    double const reach = shape.kind == ShapeKind::quad ? 0.6 : 10 * size;
    auto const along = [&] {
        return seldom(random, 8) ? with_any_sign(random, 0.5 + with_any_sign(random, log_uniform(random, 1e-7, 0.1)))
                                 : random.uniform(-reach, reach);
    };
    double const a = along();
    return center + a * dvec3(shape.a) + along() * dvec3(shape.b);
}

glm::dvec3 normal_of(Shape const& shape)
{
    return shape.kind == ShapeKind::quad ? glm::normalize(glm::cross(dvec3(shape.a), dvec3(shape.b))) : dvec3(shape.a);
}

/// Past a sphere at nearly its radius, or along a plane with nearly no slope.
glm::dvec3 grazing_direction(Random& random, Shape const& shape, glm::dvec3& target, double size)
{
    double const slight = with_any_sign(random, log_uniform(random, 1e-7, 0.1));
    if (shape.kind == ShapeKind::sphere) {
        glm::dvec3 const out = random_direction(random);
        target = dvec3(shape.center) + out * size * (1 + slight);
        return glm::normalize(glm::cross(out, random_direction(random)));
    }
    glm::dvec3 const normal = normal_of(shape);
    return glm::normalize(glm::normalize(glm::cross(normal, random_direction(random))) + slight * normal);
}

/// Exactly parallel where frame and matrix are exact, too; or straight along an axis.
glm::dvec3 parallel_direction(Random& random, Shape const& shape)
{
    return shape.kind == ShapeKind::sphere ? any_direction(random) : glm::normalize(dvec3(shape.b));
}

Line any_ray(Random& random, Shape const& shape, double size)
{
    glm::dvec3 target = any_target(random, shape, size);
    int const kind = random.integer(0, 9);
    glm::dvec3 const direction = kind == 0   ? grazing_direction(random, shape, target, size)
                                 : kind == 1 ? parallel_direction(random, shape)
                                             : any_direction(random);
    if (kind == 2 && shape.kind == ShapeKind::sphere)  // from inside
        return {dvec3(shape.center) + random_direction(random) * size * random.uniform(0, 0.999), direction};
    double const distance = size * (random.coin() ? random.uniform(0.5, 10) : log_uniform(random, 1e-3, 1e3));
    if (kind == 3)  // away from it
        return {target + direction * distance, direction};
    return {target - direction * distance, direction};
}

glm::dmat4 any_transform(Random& random, double size)
{
    double const scale = seldom(random, 3) ? 1 : log_uniform(random, smallest_scale, largest_scale);
    glm::dmat4 matrix = any_shape_of_space(random, flattest) * scale;
    glm::dvec3 const translation =
        seldom(random, 4) ? glm::dvec3(0) : random_direction(random) * scale * size * log_uniform(random, 1e-2, 1e3);
    matrix[3] = glm::dvec4(translation, 1);
    return matrix;
}

void set_ray(IntersectQuestion& q, Line const& ray)
{
    glm::dmat4 const to_world = q.transform_objects != 0 ? dmat4(q.object_to_world) : glm::dmat4(1);
    store(glm::dvec3(to_world * glm::dvec4(ray.origin, 1)), q.origin);
    store(glm::normalize(glm::dvec3(to_world * glm::dvec4(ray.direction, 0))), q.direction);
}

/// Whether float can do what glm::inverse does: divide by the determinant, and multiply two columns with the
/// translation.
bool is_invertible(float const* matrix)
{
    glm::dmat4 const m = dmat4(matrix);
    double const determinant = std::abs(glm::determinant(glm::dmat3(m)));
    double const longest = std::max({glm::length(m[0]), glm::length(m[1]), glm::length(m[2])});
    double const translation = std::max(longest, glm::length(glm::dvec3(m[3])));
    return determinant >= least_product && longest * longest * translation <= largest_product;
}

/// Whether no hit is farther away than float can measure, however float rounds a slope.
bool is_measurable(IntersectQuestion const& q, double size)
{
    constexpr double farthest = 1e18;
    constexpr double clear_slope = 1e-3;      // float keeps its order of magnitude, whatever the matrix
    constexpr double unclear_slope = 1e-9;    // below, a slope is nothing but roundings, unless it is zero
    constexpr double flattest_float = 1e-12;  // what roundings may leave in between
    glm::dmat4 const to_world = q.transform_objects != 0 ? dmat4(q.object_to_world) : glm::dmat4(1);
    double const stretch = std::max({glm::length(to_world[0]), glm::length(to_world[1]), glm::length(to_world[2])});
    double const extent = glm::length(dvec3(q.origin)) + glm::length(glm::dvec3(to_world[3])) + 10 * size * stretch;
    if (q.shape.kind == ShapeKind::sphere)
        return extent < farthest;
    glm::dvec3 const direction = glm::inverse(glm::dmat3(to_world)) * dvec3(q.direction);
    double const slope = std::abs(glm::dot(glm::normalize(direction), normal_of(q.shape)));
    if (slope > 0 && slope < unclear_slope)
        return false;
    return extent < farthest * (slope > clear_slope ? slope : flattest_float);
}

IntersectQuestion inside(Random& random)
{
    IntersectQuestion q{};
    double const size = seldom(random, 3) ? 1 : log_uniform(random, 1e-3, 1e3);
    q.shape = any_shape(random, size);
    q.transform_objects = seldom(random, 8) ? 0 : 1;
    do {
        store(any_transform(random, size), q.object_to_world);
        set_ray(q, any_ray(random, q.shape, size));
    } while (!is_invertible(q.object_to_world) || !is_measurable(q, size));
    return q;
}

/// A ray without direction or from out of range, a matrix that cannot be inverted, numbers that are none.
IntersectQuestion outside(Random& random)
{
    IntersectQuestion q = inside(random);
    switch (random.integer(0, 4)) {
        case 0:
            spoil(random, random.coin() ? q.origin : q.direction, 3);
            return q;
        case 1:
            std::fill(std::begin(q.direction), std::end(q.direction), pick(random, {0.f, denormal, 1e-30f, 1e30f}));
            return q;
        case 2:
            std::fill_n(q.object_to_world + 4 * random.integer(0, 2), 3, pick(random, {0.f, 1e-30f, 1e30f, float_max}));
            return q;
        case 3:
            for (int i = 0; i < 12; ++i)
                q.object_to_world[i] *= random.coin() ? 1e15f : 1e-15f;
            return q;
        default:
            spoil(random, q.object_to_world, 16);
            return q;
    }
}
}  // namespace

Block hits_inside(Random& random, std::uint32_t questions)
{
    return make_block<IntersectQuestion>(Kind::intersect, random, questions, inside);
}

Block hits_outside(Random& random, std::uint32_t questions)
{
    return make_block<IntersectQuestion>(Kind::intersect, random, questions, outside);
}
}  // namespace testat
