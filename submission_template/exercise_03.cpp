// Exercise 3: texture mapping, aliasing and transformations.
// This is the only file you hand in. Every place to fill in is marked TODO.
#include <cglib/rt/intersection.h>
#include <cglib/rt/object.h>
#include <cglib/rt/ray.h>
#include <cglib/rt/raytracing_context.h>
#include <cglib/rt/render_data.h>
#include <cglib/rt/renderer.h>
#include <cglib/rt/texture.h>
#include <cglib/rt/texture_mapping.h>
#include <cglib/rt/transform.h>

#include <cglib/core/assert.h>
#include <cglib/core/glmstream.h>
#include <cglib/core/image.h>
#include <cglib/core/thread_local_data.h>

// Task a) The texel of mip level `level` in which uv lies.
// (0, 0) is the lower left corner of the texture, (1, 1) the upper right one.
glm::vec4 ImageTexture::evaluate_nearest(int level, glm::vec2 const& uv) const
{
    cg_assert(level >= 0 && level < int(mip_levels.size()));
    (void)uv;
    // TODO: turn uv into integer texel coordinates and read the texel with get_texel.
    return glm::vec4(0.f);
}

// Task b) The index in [0, size) nearest to val.
int ImageTexture::wrap_clamp(int val, int size)
{
    cg_assert(size > 0);
    (void)val;
    // TODO
    return 0;
}

// Task b) The index in [0, size) that differs from val by a multiple of size.
int ImageTexture::wrap_repeat(int val, int size)
{
    cg_assert(size > 0);
    (void)val;
    // TODO
    return 0;
}

// Task c) The values of the four texels around uv, interpolated bilinearly.
// A texel's value belongs to its centre.
glm::vec4 ImageTexture::evaluate_bilinear(int level, glm::vec2 const& uv) const
{
    cg_assert(level >= 0 && level < int(mip_levels.size()));
    (void)uv;
    // TODO
    return glm::vec4(0.f);
}

// Task d) Appends mip levels to mip_levels, each half as large as the one before, down to a single texel.
void ImageTexture::create_mipmap()
{
    // Width and height are powers of two.
    cg_assert((mip_levels[0]->getWidth() & (mip_levels[0]->getWidth() - 1)) == 0);
    cg_assert((mip_levels[0]->getHeight() & (mip_levels[0]->getHeight() - 1)) == 0);
    // TODO
}

// Task d) The size (du, dv) of the box around the pixel's footprint in uv space.
// rays go through the pixel's corners, isect is what the ray through its centre has met.
glm::vec2 Object::compute_uv_aabb_size(const Ray rays[4], Intersection const& isect)
{
    glm::vec3 intersection_positions[4] = {isect.position, isect.position, isect.position, isect.position};
    (void)rays;
    // TODO: intersect the rays with the tangent plane at isect (intersect_plane).
    // A ray that misses it leaves its entry of intersection_positions as it is.

    glm::vec2 intersection_uvs[4];
    get_intersection_uvs(intersection_positions, isect, intersection_uvs);

    // TODO: return the size of the box around intersection_uvs.
    return glm::vec2(0.f);
}

// Task d) Two mip levels filtered bilinearly, and interpolated by the size dudv of the footprint.
glm::vec4 ImageTexture::evaluate_trilinear(glm::vec2 const& uv, glm::vec2 const& dudv) const
{
    (void)uv;
    (void)dudv;
    // TODO
    return glm::vec4(0.f);
}

// Task e) The direction d after transform, with length 1.
glm::vec3 transform_direction(glm::mat4 const& transform, glm::vec3 const& d)
{
    (void)transform;
    (void)d;
    // TODO
    return glm::vec3(0.f);
}

// Task e) The position p after transform.
glm::vec3 transform_position(glm::mat4 const& transform, glm::vec3 const& p)
{
    (void)transform;
    (void)p;
    // TODO
    return glm::vec3(0.f);
}

// Task e) Meets the ray with this object. True if it is hit; then *isect tells where, in world space.
bool Object::intersect(Ray const& ray, Intersection* isect) const
{
    if (RaytracingContext::get_active()->params.transform_objects) {
        // TODO: meet the ray with geo in object space and bring the intersection back to world space.
        return false;
    }
    return geo->intersect(ray, isect);
}

// Task f) The direction d, given in the tangent space of tangent, normal (its y axis) and bitangent,
// as a direction of length 1 in object space.
glm::vec3 transform_direction_to_object_space(glm::vec3 const& d, glm::vec3 const& normal, glm::vec3 const& tangent,
                                              glm::vec3 const& bitangent)
{
    (void)d;
    (void)normal;
    (void)tangent;
    (void)bitangent;
    // TODO
    return glm::vec3(0.f);
}
