#include "stress/wide_matrices.h"

#include <glm/gtc/matrix_transform.hpp>

namespace testat {
namespace {
glm::dmat4 any_rotation(Random& random)
{
    if (!seldom(random, 4))
        return random_rotation(random);
    // Quarter turns: exact in float, many zeros.
    glm::dmat4 const turns[] = {glm::dmat4(1),
                                {0, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 0, 0, 1},
                                {0, 0, -1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1}};
    return turns[random.integer(0, 2)];
}

glm::dvec3 any_scale(Random& random, double flattest)
{
    glm::dvec3 scale = random_scale(random);
    if (seldom(random, 4))
        scale = glm::dvec3(1);
    if (seldom(random, 4))
        scale[random.integer(0, 2)] *= log_uniform(random, 1 / flattest, 1);
    if (random.coin())
        scale[random.integer(0, 2)] *= -1;
    return scale;
}

glm::dmat4 any_shear(Random& random)
{
    glm::dmat4 shear(1);
    if (seldom(random, 3)) {
        shear[1][0] = random.uniform(-2, 2);
        shear[2][1] = random.uniform(-2, 2);
        shear[2][0] = random.uniform(-2, 2);
    }
    return shear;
}
}  // namespace

glm::dmat4 any_shape_of_space(Random& random, double flattest)
{
    glm::dmat4 const first = any_rotation(random);
    glm::dmat4 const sheared = first * any_shear(random);
    glm::dmat4 const scaled = glm::scale(sheared, any_scale(random, flattest));
    return seldom(random, 3) ? scaled * any_rotation(random) : scaled;
}

glm::dvec3 any_direction(Random& random)
{
    glm::dvec3 const anywhere = random_direction(random);
    if (!seldom(random, 4))
        return anywhere;
    glm::dvec3 axis(0);
    axis[random.integer(0, 2)] = random.coin() ? 1 : -1;
    return random.coin() ? axis : glm::normalize(axis + anywhere * log_uniform(random, 1e-30, 1e-3));
}

void spoil(Random& random, float* numbers, int size)
{
    int const count = random.integer(1, 3);
    for (int i = 0; i < count; ++i)
        numbers[random.integer(0, size - 1)] =
            pick(random, {float_nan, float_infinity, -float_infinity, float_max, -float_max, 1e30f, denormal, 1e-40f});
}
}  // namespace testat
