#include <cglib/rt/intersection_tests.h>

#include <cmath>

bool intersect_sphere(glm::vec3 const& origin, glm::vec3 const& direction, glm::vec3 const& center, float radius,
                      float* t)
{
    // From the point of the line nearest to the centre, half a chord back and forth. Unlike b^2 - ac this does not
    // lose the digits of a small sphere far away. Comparisons are written so that NaN means no hit.
    float const a = glm::dot(direction, direction);
    glm::vec3 const to_origin = origin - center;
    float const middle = -glm::dot(to_origin, direction) / a;
    glm::vec3 const nearest = to_origin + middle * direction;
    float const half_chord_squared = (radius * radius - glm::dot(nearest, nearest)) / a;
    if (!(half_chord_squared >= 0.f))
        return false;
    float const half_chord = std::sqrt(half_chord_squared);
    float const first = middle - half_chord;
    float const second = middle + half_chord;
    if (!(second >= 0.f))
        return false;
    *t = first >= 0.f ? first : second;
    return true;
}

bool intersect_plane(glm::vec3 const& origin, glm::vec3 const& direction, glm::vec3 const& center,
                     glm::vec3 const& normal, float* t)
{
    float const speed = glm::dot(direction, normal);
    if (speed == 0.f)
        return false;
    *t = glm::dot(center - origin, normal) / speed;
    return *t > 0.f;
}
