#include <cglib/rt/transform.h>

namespace {
/// Shapes leave the tangent space open (zero, or FLT_MAX for the shading normal): there is nothing to transform yet.
bool is_set(glm::vec3 const& v)
{
    return v != glm::vec3(0.f) && v != glm::vec3(FLT_MAX);
}

void transform_if_set(glm::mat4 const& transform, glm::vec3* direction)
{
    if (is_set(*direction))
        *direction = transform_direction(transform, *direction);
}
}  // namespace

Ray transform_ray(Ray const& ray, glm::mat4 const& transform)
{
    if (!RaytracingContext::get_active()->params.transform_objects)
        return ray;
    return Ray(transform_position(transform, ray.origin), transform_direction(transform, ray.direction));
}

Intersection transform_intersection(Intersection const& isect, glm::mat4 const& transform,
                                    glm::mat4 const& transform_normal)
{
    if (!RaytracingContext::get_active()->params.transform_objects)
        return isect;
    Intersection result = isect;
    result.position = transform_position(transform, isect.position);
    transform_if_set(transform_normal, &result.geometric_normal);
    transform_if_set(transform_normal, &result.normal);
    transform_if_set(transform_normal, &result.tangent);
    transform_if_set(transform_normal, &result.bitangent);
    transform_if_set(transform_normal, &result.shading_normal);
    return result;
}
