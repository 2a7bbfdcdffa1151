#include "stress/subjects.h"
#include "stress/wide_matrices.h"

#include <algorithm>

// transform_direction, transform_position, transform_direction_to_object_space. Contract: affine matrices, invertible,
// of scale 1e-12 to 1e12, flattened by 1e6 at most; positions and translations up to 1e12. Directions are normalised by
// the square of their length: they are 1e-18 to 1e18 long before (their square would leave float's range otherwise),
// and they are no difference of nearly equal numbers (of which float would keep less than two bits).
namespace testat {
namespace {
constexpr double shortest = 1e-18;
constexpr double longest = 1e18;
constexpr double flattest = 1e6;

double any_length(Random& random)
{
    return seldom(random, 3) ? 1 : log_uniform(random, 1e-6, 1e6);
}

/// A coordinate up to 1e12, denormals included.
double coordinate(Random& random)
{
    if (seldom(random, 8))
        return pick(random, {0.0, 1.0, double(denormal), 1e-40});
    return with_any_sign(random,
                         seldom(random, 8) ? log_uniform(random, 1e-44, 1e12) : log_uniform(random, 1e-6, 1e12));
}

glm::dvec3 any_position(Random& random)
{
    if (random.coin())
        return random_vector(random, 10);
    double const x = coordinate(random);
    double const y = coordinate(random);
    return {x, y, coordinate(random)};
}

glm::dmat4 any_matrix(Random& random)
{
    double const scale = seldom(random, 3) ? 1 : log_uniform(random, smallest_scale, largest_scale);
    glm::dmat4 matrix = any_shape_of_space(random, flattest) * scale;
    matrix[3] = glm::dvec4(any_position(random), 1);
    return matrix;
}

/// Whether float can normalise the sum of these three vectors, weighted by d.
bool can_be_normalized(glm::dvec3 const (&axes)[3], glm::dvec3 d)
{
    glm::dvec3 const sum = d.x * axes[0] + d.y * axes[1] + d.z * axes[2];
    glm::dvec3 const magnitude = glm::abs(d.x * axes[0]) + glm::abs(d.y * axes[1]) + glm::abs(d.z * axes[2]);
    double const length = glm::length(sum);
    return length >= shortest && length <= longest && 6 * eps * glm::length(magnitude) < length / 4;
}

bool is_allowed(TransformQuestion const& q)
{
    glm::dvec3 const axes[] = {dvec3(q.matrix), dvec3(q.matrix + 4), dvec3(q.matrix + 8)};
    return can_be_normalized(axes, dvec3(q.vector));
}

bool is_allowed(TangentSpaceQuestion const& q)
{
    glm::dvec3 const axes[] = {dvec3(q.tangent), dvec3(q.normal), dvec3(q.bitangent)};
    return can_be_normalized(axes, dvec3(q.d));
}

TransformQuestion direction_inside(Random& random)
{
    TransformQuestion q{};
    do {
        store(any_matrix(random), q.matrix);
        store(any_direction(random) * any_length(random), q.vector);
    } while (!is_allowed(q));
    return q;
}

TransformQuestion position_inside(Random& random)
{
    TransformQuestion q{};
    store(any_matrix(random), q.matrix);
    store(any_position(random), q.vector);
    return q;
}

/// Nothing to normalise, a matrix that is singular or not affine, or numbers out of range.
TransformQuestion outside(Random& random)
{
    TransformQuestion q = position_inside(random);
    switch (random.integer(0, 3)) {
        case 0:
            std::fill(std::begin(q.vector), std::end(q.vector),
                      pick(random, {0.f, denormal, 1e-30f, 1e30f, float_max}));
            return q;
        case 1:
            std::fill_n(q.matrix + 4 * random.integer(0, 2), 3, 0.f);
            return q;
        case 2:
            q.matrix[4 * random.integer(0, 3) + 3] = pick(random, {-1.f, 0.f, 0.5f, 1e30f, float_nan});
            return q;
        default:
            spoil(random, random.coin() ? q.matrix : q.vector, 3);
            return q;
    }
}

/// Perpendicular axes, right-handed or left-handed, or askew as interpolated ones are.
TangentSpaceQuestion frame_inside(Random& random)
{
    TangentSpaceQuestion q{};
    do {
        glm::dmat3 axes(seldom(random, 4) ? glm::dmat4(1) : random_rotation(random));
        if (seldom(random, 3))
            axes[2] = -axes[2];
        double const askew = seldom(random, 3) ? log_uniform(random, 1e-6, 1) : 0;
        for (int i = 0; i < 3; ++i)
            axes[i] = glm::normalize(axes[i] + askew * random_vector(random, 1));
        store(axes[0], q.tangent);
        store(axes[1], q.normal);
        store(axes[2], q.bitangent);
        store(any_direction(random) * log_uniform(random, 2 * shortest, longest / 2), q.d);
    } while (!is_allowed(q));
    return q;
}

TangentSpaceQuestion frame_outside(Random& random)
{
    TangentSpaceQuestion q = frame_inside(random);
    switch (random.integer(0, 2)) {
        case 0:
            std::fill(std::begin(q.d), std::end(q.d), pick(random, {0.f, denormal, 1e-30f, 1e30f, float_max}));
            return q;
        case 1:
            std::fill(std::begin(q.tangent), std::end(q.tangent), pick(random, {0.f, float_nan, 1e30f}));
            return q;
        default:
            spoil(random, q.d, 3);
            return q;
    }
}
}  // namespace

Block directions_inside(Random& random, std::uint32_t questions)
{
    return make_block<TransformQuestion>(Kind::transform, random, questions, direction_inside);
}

Block directions_outside(Random& random, std::uint32_t questions)
{
    return make_block<TransformQuestion>(Kind::transform, random, questions, outside);
}

Block positions_inside(Random& random, std::uint32_t questions)
{
    return make_block<TransformQuestion>(Kind::transform, random, questions, position_inside);
}

Block positions_outside(Random& random, std::uint32_t questions)
{
    return make_block<TransformQuestion>(Kind::transform, random, questions, outside);
}

Block frames_inside(Random& random, std::uint32_t questions)
{
    return make_block<TangentSpaceQuestion>(Kind::tangent_space, random, questions, frame_inside);
}

Block frames_outside(Random& random, std::uint32_t questions)
{
    return make_block<TangentSpaceQuestion>(Kind::tangent_space, random, questions, frame_outside);
}
}  // namespace testat
