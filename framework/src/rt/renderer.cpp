#include <cglib/rt/renderer.h>

#include "culling.h"
#include "render_modes.h"

#include <cglib/core/thread_pool.h>
#include <cglib/rt/prepared_render.h>
#include <cglib/rt/scene.h>

#include <algorithm>

namespace {
int const tile_rows = 8;

/// Calls test(index) for the objects that the ray may meet, as Culling::visit does.
template <class Test>
void visit_objects(RenderData& data, Ray const& ray, float t_max, Test const& test)
{
    if (data.context.culling)
        return data.context.culling->visit(ray, t_max, test);
    int const count = int(data.context.scene->objects.size());
    for (int i = 0; i < count && t_max >= 0.f; ++i)
        t_max = test(i);
}

bool meets(RenderData& data, int index, Ray const& ray, Intersection* isect)
{
    ++data.context.stats.object_tests;
    return data.context.scene->objects[std::size_t(index)]->intersect(ray, isect);
}

std::vector<Tile> tiles_of(RaytracingParameters const& params)
{
    std::vector<Tile> tiles;
    for (int y = 0; y < params.height; y += tile_rows)
        tiles.push_back({0, y, params.width, std::min(y + tile_rows, params.height)});
    return tiles;
}
}  // namespace

RenderStats render_scene(Scene& scene, RaytracingParameters const& params, Image* image, RenderOptions const& options)
{
    PreparedRender const prepared(scene, params, options.culling);
    image->setSize(params.width, params.height);
    std::vector<Tile> const tiles = tiles_of(params);
    std::vector<RenderStats> counts(tiles.size());
    ThreadPool(options.threads).run(int(tiles.size()), [&](int i) {
        counts[std::size_t(i)] = prepared.render(tiles[std::size_t(i)], image);
    });
    RenderStats sum = prepared.preparation();
    for (RenderStats const& count : counts)
        sum += count;
    return sum;
}

glm::vec3 render_sample(RaytracingContext& context, glm::vec2 const& pixel, ThreadLocalData& thread)
{
    RenderData data(context, thread, pixel);
    ++context.stats.camera_rays;
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
    int nearest = -1;
    *isect = Intersection();
    visit_objects(data, ray, FLT_MAX, [&](int i) {
        // Starting from a clean intersection, as submissions may read it.
        Intersection candidate;
        bool const hit = meets(data, i, ray, &candidate);
        if (hit && (candidate.t < isect->t || (candidate.t == isect->t && i < nearest))) {
            nearest = i;
            *isect = candidate;
        }
        return isect->t;
    });
    return nearest < 0 ? nullptr : data.context.scene->objects[std::size_t(nearest)].get();
}

bool is_visible(RenderData& data, glm::vec3 const& from, glm::vec3 const& to)
{
    ++data.num_rays;
    ++data.context.stats.shadow_rays;
    float const epsilon = data.context.params.ray_epsilon;
    Ray ray(from, to - from);
    float const distance = glm::length(to - from) - 2.f * epsilon;
    ray.origin += epsilon * ray.direction;
    bool visible = true;
    visit_objects(data, ray, distance, [&](int i) {
        Intersection isect;
        visible = !(meets(data, i, ray, &isect) && isect.t < distance);
        return visible ? distance : -1.f;
    });
    return visible;
}
