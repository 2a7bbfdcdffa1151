#include "envelopes/perturbed.h"

#include <cglib/rt/texture_access.h>
#include "probe/slots.h"

#include <cglib/rt/intersection_tests.h>
#include <cglib/rt/object.h>
#include <cglib/rt/transform.h>

#include <array>
#include <random>

// The wrappers stand in the slots of member functions: on the Itanium C++ ABI a member function is called like a
// function whose first parameter is `this`.
namespace testat {
namespace {
constexpr float roundings = 8 * 0x1p-24f;

std::mt19937_64 engine;
float strength = 0;

/// Uniform in [-1, 1), times eight roundings of `magnitude`.
float noise(float magnitude)
{
    double const unit = double(engine() >> 11) * 0x1p-52 - 1;
    return strength * roundings * magnitude * float(unit);
}

template <typename Vector>
Vector moved(Vector v, float magnitude)
{
    for (int i = 0; i < v.length(); ++i)
        v[i] += noise(magnitude);
    return v;
}

/// Each component by its own size.
template <typename Vector>
Vector rounded(Vector v)
{
    for (int i = 0; i < v.length(); ++i)
        v[i] += noise(std::abs(v[i]));
    return v;
}

/// uv by |u| + 0.5: products with the size of the texture, less half a texel.
glm::vec2 moved_uv(glm::vec2 uv)
{
    return {uv.x + noise(std::abs(uv.x) + 0.5f), uv.y + noise(std::abs(uv.y) + 0.5f)};
}

std::array<Code, function_count> reference;

template <typename Signature>
Signature* original(Function f)
{
    return reinterpret_cast<Signature*>(reference[static_cast<std::uint32_t>(f)]);
}

using LevelLookup = glm::vec4(ImageTexture const*, int, glm::vec2 const&);
using FootprintLookup = glm::vec4(ImageTexture const*, glm::vec2 const&, glm::vec2 const&);
using Meet = bool(Object const*, Ray const&, Intersection*);
using Transform = glm::vec3(glm::mat4 const&, glm::vec3 const&);
using ToObjectSpace = glm::vec3(glm::vec3 const&, glm::vec3 const&, glm::vec3 const&, glm::vec3 const&);

glm::vec4 evaluate_nearest(ImageTexture const* self, int level, glm::vec2 const& uv)
{
    return original<LevelLookup>(Function::evaluate_nearest)(self, level, moved_uv(uv));
}

glm::vec4 evaluate_bilinear(ImageTexture const* self, int level, glm::vec2 const& uv)
{
    return rounded(original<LevelLookup>(Function::evaluate_bilinear)(self, level, moved_uv(uv)));
}

glm::vec4 evaluate_trilinear(ImageTexture const* self, glm::vec2 const& uv, glm::vec2 const& dudv)
{
    return rounded(original<FootprintLookup>(Function::evaluate_trilinear)(self, moved_uv(uv), rounded(dudv)));
}

/// Every level adds its own roundings to those of the finer ones; who adds up all texels of level 0 instead makes more,
/// which grow with the side of a block.
void create_mipmap(ImageTexture* self)
{
    original<void(ImageTexture*)>(Function::create_mipmap)(self);
    auto& levels = TextureAccess::levels(*self);
    for (std::size_t level = 1; level < levels.size(); ++level)
        for (int y = 0; y < levels[level]->getHeight(); ++y)
            for (int x = 0; x < levels[level]->getWidth(); ++x) {
                glm::vec4 const mean = levels[level]->getPixel(x, y);
                levels[level]->setPixel(x, y, moved(mean, std::max(float(level), 0.25f * float(1u << level))));
            }
}

/// The reference's own steps, with each corner hit moved by |o| + t.
glm::vec2 compute_uv_aabb_size(Object* self, Ray const* rays, Intersection const& isect)
{
    glm::vec3 positions[4] = {isect.position, isect.position, isect.position, isect.position};
    for (int i = 0; i < 4; ++i) {
        float t;
        if (intersect_plane(rays[i].origin, rays[i].direction, isect.position, isect.normal, &t))
            positions[i] = moved(rays[i].origin + t * rays[i].direction, glm::length(rays[i].origin) + t);
    }
    glm::vec2 uvs[4];
    self->get_intersection_uvs(positions, isect, uvs);
    return glm::max(glm::max(uvs[0], uvs[1]), glm::max(uvs[2], uvs[3])) -
           glm::min(glm::min(uvs[0], uvs[1]), glm::min(uvs[2], uvs[3]));
}

bool intersect(Object const* self, Ray const& ray, Intersection* isect)
{
    if (!original<Meet>(Function::intersect)(self, ray, isect))
        return false;
    float const reach = glm::length(ray.origin) + isect->t;
    isect->position = moved(isect->position, reach);
    isect->t += noise(reach);
    return true;
}

glm::vec3 transform_direction(glm::mat4 const& transform, glm::vec3 const& d)
{
    return moved(original<Transform>(Function::transform_direction)(transform, d), 1);
}

glm::vec3 transform_position(glm::mat4 const& transform, glm::vec3 const& p)
{
    float const magnitude = glm::length(glm::vec3(transform[3])) + glm::length(p);
    return moved(original<Transform>(Function::transform_position)(transform, p), magnitude);
}

glm::vec3 transform_direction_to_object_space(glm::vec3 const& d, glm::vec3 const& normal, glm::vec3 const& tangent,
                                              glm::vec3 const& bitangent)
{
    auto const to_object_space = original<ToObjectSpace>(Function::transform_direction_to_object_space);
    return moved(to_object_space(d, normal, tangent, bitangent), 1);
}

template <typename Signature>
void put(Function f, Signature* wrapper)
{
    set_slot(f, reinterpret_cast<Code>(wrapper));
}
}  // namespace

void perturb_slots()
{
    for (Function f : every_function())
        reference[static_cast<std::uint32_t>(f)] = get_slot(f);
    put(Function::evaluate_nearest, evaluate_nearest);
    put(Function::evaluate_bilinear, evaluate_bilinear);
    put(Function::evaluate_trilinear, evaluate_trilinear);
    put(Function::create_mipmap, create_mipmap);
    put(Function::compute_uv_aabb_size, compute_uv_aabb_size);
    put(Function::intersect, intersect);
    put(Function::transform_direction, transform_direction);
    put(Function::transform_position, transform_position);
    put(Function::transform_direction_to_object_space, transform_direction_to_object_space);
}

void set_perturbation_seed(std::uint64_t seed)
{
    engine.seed(seed);
    strength = seed == 0 ? 0.f : 1.f;
}
}  // namespace testat
