#include "checks/matrices.h"

#include <glm/gtc/matrix_transform.hpp>

namespace testat {
glm::dvec3 random_vector(Random& random, double extent)
{
    double const x = random.uniform(-extent, extent);
    double const y = random.uniform(-extent, extent);
    return {x, y, random.uniform(-extent, extent)};
}

glm::dvec3 random_direction(Random& random)
{
    for (;;) {
        glm::dvec3 const v = random_vector(random, 1);
        double const length = glm::length(v);
        if (length > 0.1 && length < 1)
            return v / length;
    }
}

glm::dmat4 random_rotation(Random& random)
{
    double const angle = random.uniform(-3.14, 3.14);
    return glm::rotate(glm::dmat4(1), angle, random_direction(random));
}

glm::dvec3 random_scale(Random& random)
{
    glm::dvec3 const exponents = random_vector(random, 2);
    return glm::exp2(exponents);
}
}  // namespace testat
