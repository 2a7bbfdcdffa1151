#include <cglib/rt/shading.h>

#include <cglib/rt/renderer.h>
#include <cglib/rt/scene.h>

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>

namespace {
/// In pixels from the sample's position; opposite corners follow each other.
glm::vec2 const corners[4] = {{-0.5f, -0.5f}, {0.5f, 0.5f}, {-0.5f, 0.5f}, {0.5f, -0.5f}};

glm::vec3 trace(RenderData& data, Ray const& ray, int depth);

/// From the surface on, so far that it does not hit the surface again.
Ray leave(RenderData const& data, glm::vec3 const& position, glm::vec3 const& direction)
{
    Ray ray(position, direction);
    ray.origin += data.context.params.ray_epsilon * ray.direction;
    return ray;
}

glm::vec3 trace_reflected(RenderData& data, Ray const& ray, Intersection const& isect, int depth)
{
    if (!data.context.plan->reflected_rays || depth > data.context.params.max_depth)
        return glm::vec3(0.f);
    ++data.context.stats.reflected_rays;
    return trace(data, leave(data, isect.position, glm::reflect(ray.direction, isect.shading_normal)), depth);
}

glm::vec3 trace_transmitted(RenderData& data, Intersection const& isect, glm::vec3 const& refracted, int depth)
{
    if (depth > data.context.params.max_depth)
        return glm::vec3(0.f);
    ++data.context.stats.transmitted_rays;
    return trace(data, leave(data, isect.position, refracted), depth);
}

/// Through the surface, refracted. With Fresnel's equations a share is reflected, which is all of it where nothing can
/// pass.
glm::vec3 trace_through(RenderData& data, Ray const& ray, Intersection isect, int depth)
{
    bool const leaving = glm::dot(isect.geometric_normal, ray.direction) > 0.f;
    if (leaving)
        isect.shading_normal = -isect.shading_normal;
    float const eta = leaving ? isect.material.eta : 1.f / isect.material.eta;
    float const cosine = std::max(0.f, -glm::dot(isect.shading_normal, ray.direction));
    glm::vec3 const refracted = glm::refract(ray.direction, isect.shading_normal, eta);
    bool const total = refracted == glm::vec3(0.f);
    float const share = total ? 1.f : data.context.params.fresnel ? fresnel(cosine, eta) : 0.f;
    glm::vec3 sum(0.f);
    if (share > 0.f)
        sum += share * trace_reflected(data, ray, isect, depth);
    if (share < 1.f)
        sum += (1.f - share) * trace_transmitted(data, isect, refracted, depth);
    return sum;
}

void complete_hit(RenderData& data, Object& object, Intersection* isect, int depth)
{
    if (depth == 0)
        complete_camera_hit(data, object, isect);
    else
        object.compute_shading_info(isect);
}

glm::vec3 shade(RenderData& data, Ray const& ray, Intersection const& isect, int depth)
{
    if (is_dark_side(ray, isect))
        return glm::vec3(0.f);
    MaterialSample const& material = isect.material;
    glm::vec3 sum = phong(data, ray, isect);
    if (material.k_r != glm::vec3(0.f))
        sum += material.k_r * trace_reflected(data, ray, isect, depth + 1);
    if (data.context.plan->transmitted_rays && material.k_t != glm::vec3(0.f))
        sum += material.k_t * trace_through(data, ray, isect, depth + 1);
    return sum;
}

glm::vec3 trace(RenderData& data, Ray const& ray, int depth)
{
    Intersection isect;
    Object* const object = find_nearest_hit(data, ray, &isect);
    if (!object)
        return look_up_environment(data, ray.direction);
    complete_hit(data, *object, &isect, depth);
    return shade(data, ray, isect, depth);
}
}  // namespace

glm::vec3 trace_camera_ray(RenderData& data, Ray const& ray)
{
    return trace(data, ray, 0);
}

void complete_camera_hit(RenderData& data, Object& object, Intersection* isect)
{
    if (!data.context.plan->needs_footprint(*object.material))
        return object.compute_shading_info(isect);
    Ray rays[4];
    for (int i = 0; i < 4; ++i)
        rays[i] = camera_ray(data.context, data.pixel + corners[i]);
    data.context.stats.corner_rays += 4;
    object.compute_shading_info(rays, isect);
}

glm::vec3 look_up_environment(RenderData& data, glm::vec3 const& direction)
{
    ImageTexture const* const texture = data.context.plan->environment_texture.get();
    if (!texture)
        return glm::vec3(0.f);
    ++data.context.stats.environment_lookups;
    float const x = (std::atan2(direction.z, direction.x) + glm::pi<float>()) / glm::two_pi<float>();
    float const y = (std::asin(glm::clamp(direction.y, -1.f, 1.f)) + glm::half_pi<float>()) / glm::pi<float>();
    return glm::vec3(texture->evaluate(glm::vec2(x, y)));
}

float fresnel(float cos_in, float eta)
{
    float const sin_out_squared = eta * eta * (1.f - cos_in * cos_in);
    if (!(sin_out_squared < 1.f))
        return 1.f;
    float const cos_out = std::sqrt(1.f - sin_out_squared);
    float const parallel = (cos_in - eta * cos_out) / (cos_in + eta * cos_out);
    float const perpendicular = (eta * cos_in - cos_out) / (eta * cos_in + cos_out);
    return 0.5f * (parallel * parallel + perpendicular * perpendicular);
}
