#include "render_modes.h"

#include <cglib/core/heatmap.h>
#include <cglib/core/timer.h>
#include <cglib/rt/object.h>
#include <cglib/rt/renderer.h>
#include <cglib/rt/shading.h>

#include <cmath>

namespace {
/// What the heatmaps show in red.
float const many_rays = 64.f;
float const long_seconds = 20e-6f;
/// Luminance of linear rgb (Rec. 709).
glm::vec3 const luminance(0.2126f, 0.7152f, 0.0722f);

glm::vec3 show_normal(RenderData& data, Ray const& ray)
{
    Intersection isect;
    Object* const object = find_nearest_hit(data, ray, &isect);
    if (!object)
        return glm::vec3(0.f);
    if (!data.context.plan->normal_maps)
        return isect.normal * 0.5f + 0.5f;
    complete_camera_hit(data, *object, &isect);
    return isect.shading_normal * 0.5f + 0.5f;
}

glm::vec3 show_footprint(RenderData& data, Ray const& ray)
{
    Intersection isect;
    Object* const object = find_nearest_hit(data, ray, &isect);
    if (!object)
        return glm::vec3(0.f);
    complete_camera_hit(data, *object, &isect);
    return heatmap(std::log(1.f + 5.f * glm::length(isect.dudv)));
}

glm::vec3 show_num_rays(RenderData& data, Ray const& ray)
{
    trace_camera_ray(data, ray);
    return heatmap(float(data.num_rays) / many_rays);
}

glm::vec3 show_time(RenderData& data, Ray const& ray)
{
    Timer const timer;
    trace_camera_ray(data, ray);
    return heatmap(float(timer.seconds()) / long_seconds);
}
}  // namespace

glm::vec3 render_ray(RenderData& data, Ray const& ray)
{
    switch (data.context.params.render_mode) {
        case DESATURATE:
            return glm::vec3(glm::dot(trace_camera_ray(data, ray), luminance));
        case NUM_RAYS:
            return show_num_rays(data, ray);
        case NORMAL:
            return show_normal(data, ray);
        case TIME:
            return show_time(data, ray);
        case DUDV:
            return show_footprint(data, ray);
        default:
            return trace_camera_ray(data, ray);
    }
}
