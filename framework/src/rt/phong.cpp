// What lights send back from a surface.
#include <cglib/rt/renderer.h>
#include <cglib/rt/scene.h>
#include <cglib/rt/shading.h>

#include <algorithm>
#include <cmath>

namespace {
/// The unit directions of Phong's model at a hit.
struct Directions {
    glm::vec3 normal;
    glm::vec3 to_viewer;
    glm::vec3 to_light;
};

glm::vec3 diffuse(MaterialSample const& material, Directions const& d)
{
    return material.k_d * std::max(0.f, glm::dot(d.normal, d.to_light));
}

glm::vec3 specular(MaterialSample const& material, Directions const& d)
{
    if (material.k_s == glm::vec3(0.f))
        return glm::vec3(0.f);
    glm::vec3 const reflected = glm::reflect(-d.to_light, d.normal);
    return material.k_s * std::pow(std::max(0.f, glm::dot(reflected, d.to_viewer)), material.n);
}

/// The part of the light that comes straight from the light, and is lost in a shadow.
glm::vec3 direct(RaytracingParameters const& params, MaterialSample const& material, Directions const& d)
{
    glm::vec3 sum(0.f);
    if (!(glm::dot(d.normal, d.to_light) > 0.f))
        return sum;
    if (params.diffuse)
        sum += diffuse(material, d);
    if (params.specular)
        sum += specular(material, d);
    return sum;
}

/// The share of a light's power, at distance 1, that is sent to the viewer.
glm::vec3 reflected_share(RenderData& data, Intersection const& isect, Light const& light, Directions const& d)
{
    RaytracingParameters const& params = data.context.params;
    glm::vec3 share = direct(params, isect.material, d);
    if (data.context.plan->shadow_rays && share != glm::vec3(0.f) && !is_visible(data, isect.position, light.position))
        share = glm::vec3(0.f);
    return params.ambient ? share + isect.material.k_a : share;
}
}  // namespace

bool is_dark_side(Ray const& ray, Intersection const& isect)
{
    bool const behind = glm::dot(isect.geometric_normal, -ray.direction) < 0.f;
    return behind && isect.material.k_t == glm::vec3(0.f);
}

glm::vec3 phong(RenderData& data, Ray const& ray, Intersection const& isect)
{
    glm::vec3 sum(0.f);
    if (is_dark_side(ray, isect))
        return sum;
    for (Light const& light : data.context.scene->lights) {
        glm::vec3 const to_light = light.position - isect.position;
        Directions const directions{isect.shading_normal, -ray.direction, glm::normalize(to_light)};
        sum += reflected_share(data, isect, light, directions) * light.power / glm::dot(to_light, to_light);
    }
    return sum;
}
