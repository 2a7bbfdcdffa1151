// The reference solution: what the exercise sheet asks for, as plainly as we can say it.
#include <cglib/rt/intersection.h>
#include <cglib/rt/intersection_tests.h>
#include <cglib/rt/object.h>
#include <cglib/rt/ray.h>
#include <cglib/rt/raytracing_context.h>
#include <cglib/rt/texture.h>
#include <cglib/rt/transform.h>

#include <cglib/core/assert.h>
#include <cglib/core/image.h>

#include <algorithm>
#include <cmath>
#include <memory>

glm::vec4 ImageTexture::evaluate_nearest(int level, glm::vec2 const& uv) const
{
    Image const& image = *mip_levels[level];
    int const x = int(std::floor(uv.x * float(image.getWidth())));
    int const y = int(std::floor(uv.y * float(image.getHeight())));
    return get_texel(level, x, y);
}

int ImageTexture::wrap_clamp(int val, int size)
{
    return std::min(std::max(val, 0), size - 1);
}

int ImageTexture::wrap_repeat(int val, int size)
{
    int const remainder = val % size;
    return remainder < 0 ? remainder + size : remainder;
}

glm::vec4 ImageTexture::evaluate_bilinear(int level, glm::vec2 const& uv) const
{
    Image const& image = *mip_levels[level];
    // Texel values belong to texel centres, which lie at half-integer st.
    float const s = uv.x * float(image.getWidth()) - 0.5f;
    float const t = uv.y * float(image.getHeight()) - 0.5f;
    float const s0 = std::floor(s);
    float const t0 = std::floor(t);
    int const x = int(s0);
    int const y = int(t0);

    glm::vec4 const lower = glm::mix(get_texel(level, x, y), get_texel(level, x + 1, y), s - s0);
    glm::vec4 const upper = glm::mix(get_texel(level, x, y + 1), get_texel(level, x + 1, y + 1), s - s0);
    return glm::mix(lower, upper, t - t0);
}

void ImageTexture::create_mipmap()
{
    mip_levels.resize(1);
    while (mip_levels.back()->getWidth() > 1 || mip_levels.back()->getHeight() > 1) {
        Image const& finer = *mip_levels.back();
        int const width = std::max(1, finer.getWidth() / 2);
        int const height = std::max(1, finer.getHeight() / 2);
        // A side that is one texel long already is not halved: its blocks are one texel wide.
        int const step_x = finer.getWidth() / width;
        int const step_y = finer.getHeight() / height;

        auto coarser = std::make_shared<Image>(width, height);
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                glm::vec4 sum(0.f);
                for (int j = 0; j < step_y; ++j)
                    for (int i = 0; i < step_x; ++i)
                        sum += finer.getPixel(x * step_x + i, y * step_y + j);
                coarser->setPixel(x, y, sum / float(step_x * step_y));
            }
        }
        mip_levels.push_back(coarser);
    }
}

glm::vec2 Object::compute_uv_aabb_size(const Ray rays[4], Intersection const& isect)
{
    glm::vec3 intersection_positions[4] = {isect.position, isect.position, isect.position, isect.position};
    for (int i = 0; i < 4; ++i) {
        float t;
        if (intersect_plane(rays[i].origin, rays[i].direction, isect.position, isect.normal, &t))
            intersection_positions[i] = rays[i].origin + t * rays[i].direction;
    }

    glm::vec2 intersection_uvs[4];
    get_intersection_uvs(intersection_positions, isect, intersection_uvs);

    glm::vec2 lower = intersection_uvs[0];
    glm::vec2 upper = intersection_uvs[0];
    for (int i = 1; i < 4; ++i) {
        lower = glm::min(lower, intersection_uvs[i]);
        upper = glm::max(upper, intersection_uvs[i]);
    }
    return upper - lower;
}

glm::vec4 ImageTexture::evaluate_trilinear(glm::vec2 const& uv, glm::vec2 const& dudv) const
{
    Image const& finest = *mip_levels[0];
    float const footprint = std::max(dudv.x * float(finest.getWidth()), dudv.y * float(finest.getHeight()));
    int const last = int(mip_levels.size()) - 1;
    // A footprint of at most one texel is magnified: log2 would be negative, or minus infinity for none at all.
    if (!(footprint > 1.f))
        return evaluate_bilinear(0, uv);
    float const level = std::log2(footprint);
    if (level >= float(last))
        return evaluate_bilinear(last, uv);
    int const finer = int(level);
    return glm::mix(evaluate_bilinear(finer, uv), evaluate_bilinear(finer + 1, uv), level - float(finer));
}

glm::vec3 transform_direction(glm::mat4 const& transform, glm::vec3 const& d)
{
    return glm::normalize(glm::vec3(transform * glm::vec4(d, 0.f)));
}

glm::vec3 transform_position(glm::mat4 const& transform, glm::vec3 const& p)
{
    return glm::vec3(transform * glm::vec4(p, 1.f));
}

bool Object::intersect(Ray const& ray, Intersection* isect) const
{
    if (!RaytracingContext::get_active()->params.transform_objects)
        return geo->intersect(ray, isect);

    Ray const object_ray = transform_ray(ray, transform_world_to_object);
    if (!geo->intersect(object_ray, isect))
        return false;
    *isect = transform_intersection(*isect, transform_object_to_world, transform_object_to_world_normal);
    // Rays are unit in both spaces, so the distance is measured again in the world's.
    isect->t = glm::length(isect->position - ray.origin);
    return true;
}

glm::vec3 transform_direction_to_object_space(glm::vec3 const& d, glm::vec3 const& normal, glm::vec3 const& tangent,
                                              glm::vec3 const& bitangent)
{
    return glm::normalize(glm::mat3(tangent, normal, bitangent) * d);
}
