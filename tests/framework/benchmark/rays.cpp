// How near the renderer's ray loop is to a bare loop: rays a second through find_nearest_hit, against four ellipsoids
// at a time in SIMD for the same camera rays and the same stones, one thread. Both alternate; the minimum of nine
// counts.
#include <cglib/core/build_paths.h>
#include <cglib/rt/renderer.h>
#include <cglib/rt/scenes.h>

#include "culling.h"

#include <algorithm>
#include <cstdio>
#include <ctime>

namespace {
int const side = 256;
int const repetitions = 9;

using Floats = float __attribute__((vector_size(16)));

/// Four stones: rows of world-to-object, so that a stone is a unit sphere.
struct Stones {
    Floats m[3][4];
};

double cpu_seconds()
{
    timespec now = {};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

std::vector<Stones> gather(Scene const& scene)
{
    std::vector<Stones> stones;
    int count = 0;
    for (auto const& object : scene.objects) {
        auto const* sphere = dynamic_cast<Sphere const*>(object->geo.get());
        if (!sphere)
            continue;
        if (count % 4 == 0)
            stones.push_back({});
        glm::mat4 const m =
            glm::scale(glm::mat4(1.f), glm::vec3(1.f / sphere->radius)) * object->transform_world_to_object;
        for (int row = 0; row < 3; ++row)
            for (int column = 0; column < 4; ++column)
                stones.back().m[row][column][count % 4] = m[column][row];
        ++count;
    }
    return stones;
}

/// Half the squared chord where a ray meets one of four unit spheres, and -1 elsewhere: enough to know the hit.
Floats meet(Stones const& stones, Ray const& ray)
{
    Floats o[3], d[3];
    for (int row = 0; row < 3; ++row) {
        Floats const* m = stones.m[row];
        o[row] = m[0] * ray.origin.x + m[1] * ray.origin.y + m[2] * ray.origin.z + m[3];
        d[row] = m[0] * ray.direction.x + m[1] * ray.direction.y + m[2] * ray.direction.z;
    }
    Floats const a = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
    Floats const b = o[0] * d[0] + o[1] * d[1] + o[2] * d[2];
    Floats const c = o[0] * o[0] + o[1] * o[1] + o[2] * o[2] - 1.f;
    Floats const discriminant = b * b - a * c;
    Floats const none = {-1.f, -1.f, -1.f, -1.f};
    return (discriminant > 0.f) & (b < 0.f) ? discriminant / a : none;
}

double bare_loop(std::vector<Stones> const& stones, std::vector<Ray> const& rays, int* hits)
{
    double const start = cpu_seconds();
    for (Ray const& ray : rays) {
        Floats best = {-1.f, -1.f, -1.f, -1.f};
        for (Stones const& four : stones) {
            Floats const met = meet(four, ray);
            best = met > best ? met : best;
        }
        *hits += best[0] > 0.f || best[1] > 0.f || best[2] > 0.f || best[3] > 0.f ? 1 : 0;
    }
    return cpu_seconds() - start;
}

double renderer_loop(RaytracingContext& context, std::vector<Ray> const& rays, int* hits)
{
    ThreadLocalData thread;
    RenderData data(context, thread);
    double const start = cpu_seconds();
    Intersection isect;
    for (Ray const& ray : rays)
        *hits += find_nearest_hit(data, ray, &isect) ? 1 : 0;
    return cpu_seconds() - start;
}
}  // namespace

int main()
{
    AssetLibrary assets(assets_directory());
    auto const scene = create_scene("goboard", assets);
    scene->objects.erase(scene->objects.begin());  // the board
    Culling const culling(scene->objects, true);
    RaytracingContext context;
    context.scene = scene.get();
    context.culling = &culling;
    RaytracingContext::Activation const activation(context);
    std::vector<Ray> rays;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            rays.push_back(camera_ray(context, glm::vec2(float(x) + 0.5f, float(y) + 0.5f)));
    auto const stones = gather(*scene);
    double bare = 1e9;
    double ours = 1e9;
    int bare_hits = 0;
    int our_hits = 0;
    for (int i = 0; i < repetitions; ++i) {
        bare = std::min(bare, bare_loop(stones, rays, &bare_hits));
        ours = std::min(ours, renderer_loop(context, rays, &our_hits));
    }
    double const million = 1e-6 * double(rays.size());
    std::printf("%zu stones, %zu camera rays, one thread\n", scene->objects.size(), rays.size());
    std::printf("  bare SIMD loop    %6.1f million rays/s, %d hits\n", million / bare, bare_hits / repetitions);
    std::printf("  find_nearest_hit  %6.1f million rays/s, %d hits\n", million / ours, our_hits / repetitions);
    std::printf("  ratio             %6.2f\n", bare / ours);
    return 0;
}
