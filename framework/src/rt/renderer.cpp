#include <cglib/rt/renderer.h>

#include "render_modes.h"

#include <cglib/rt/host_render.h>
#include <cglib/rt/sampling_patterns.h>
#include <cglib/rt/scene.h>

namespace {
/// In pixels from the sample's position; opposite corners follow each other.
glm::vec2 const corners[4] = {{-0.5f, -0.5f}, {0.5f, 0.5f}, {-0.5f, 0.5f}, {0.5f, -0.5f}};

/// Meets the ray with one object, starting from a clean intersection as submissions may read it.
void keep_nearer_hit(Object* object, Ray const& ray, Object** nearest, Intersection* isect)
{
    Intersection candidate;
    if (!object->intersect(ray, &candidate) || !(candidate.t < isect->t))
        return;
    *nearest = object;
    *isect = candidate;
}

void set_corner_rays(RenderData& data, glm::vec2 const& pixel)
{
    for (int i = 0; i < 4; ++i)
        data.corner_rays[i] = camera_ray(data.context, pixel + corners[i]);
    data.has_corner_rays = true;
}

glm::vec3 render_pixel(RaytracingContext const& context, int x, int y, ThreadLocalData& thread)
{
    RaytracingParameters const& params = context.params;
    glm::vec2 const lower_left = glm::vec2(float(x), float(y));
    if (params.spp <= 1)
        return render_sample(context, lower_left + 0.5f, thread);
    glm::vec3 sum(0.f);
    for (glm::vec2 const& position : sampling_pattern(params.spp, params.stratified, thread))
        sum += render_sample(context, lower_left + position, thread);
    return sum / float(params.spp);
}
}  // namespace

void prepare_textures(Scene& scene, RaytracingParameters const& params)
{
    for (std::shared_ptr<ImageTexture> const& texture : scene.textures) {
        texture->filter_mode = params.tex_filter_mode;
        texture->wrap_mode = params.tex_wrap_mode;
        if (needs_mip_levels(params) && texture->get_mip_levels().size() == 1)
            texture->create_mipmap();
    }
}

void render_scene(Scene& scene, RaytracingParameters const& params, Image* image)
{
    RaytracingContext context;
    context.params = params;
    context.scene = &scene;
    RaytracingContext::Activation const activation(context);
    prepare_textures(scene, params);
    image->setSize(params.width, params.height);
    host_render([&](int x, int y, ThreadLocalData& thread) { return render_pixel(context, x, y, thread); }, image);
}

glm::vec3 render_sample(RaytracingContext const& context, glm::vec2 const& pixel, ThreadLocalData& thread)
{
    RenderData data(context, thread);
    if (needs_footprints(context.params))
        set_corner_rays(data, pixel);
    return render_ray(data, camera_ray(context, pixel));
}

Ray camera_ray(RaytracingContext const& context, glm::vec2 const& pixel)
{
    RaytracingParameters const& params = context.params;
    Camera const& camera = context.scene->camera;
    return Ray(camera.position(), camera.direction(pixel, params.width, params.height, params.fovy));
}

Object* find_nearest_hit(RenderData& data, Ray const& ray, Intersection* isect)
{
    ++data.num_rays;
    Object* nearest = nullptr;
    *isect = Intersection();
    for (std::shared_ptr<Object> const& object : data.context.scene->objects)
        keep_nearer_hit(object.get(), ray, &nearest, isect);
    return nearest;
}

bool is_visible(RenderData& data, glm::vec3 const& from, glm::vec3 const& to)
{
    ++data.num_rays;
    float const epsilon = data.context.params.ray_epsilon;
    Ray ray(from, to - from);
    float const distance = glm::length(to - from) - 2.f * epsilon;
    ray.origin += epsilon * ray.direction;
    for (std::shared_ptr<Object> const& object : data.context.scene->objects) {
        Intersection isect;
        if (object->intersect(ray, &isect) && isect.t < distance)
            return false;
    }
    return true;
}
