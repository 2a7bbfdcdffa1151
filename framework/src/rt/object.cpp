#include <cglib/rt/object.h>

#include <cmath>

namespace {
/// Along u or v: mirrors the shorter of two differences to center if they point the same way.
void mend_seam(float center, float* a, float* b)
{
    float const to_a = *a - center;
    float const to_b = *b - center;
    bool const same_way = (to_a > 0.f && to_b > 0.f) || (to_a < 0.f && to_b < 0.f);
    if (!same_way)
        return;
    if (std::abs(to_a) > std::abs(to_b))
        *a = center - to_b;
    else
        *b = center - to_a;
}

void mend_seam(glm::vec2 const& center, glm::vec2* a, glm::vec2* b)
{
    mend_seam(center.x, &a->x, &b->x);
    mend_seam(center.y, &a->y, &b->y);
}
}  // namespace

Object::~Object() = default;

Object::Object(std::shared_ptr<Intersectable> shape, std::shared_ptr<TextureMapping> mapping)
    : geo(std::move(shape)), material(std::make_shared<Material>()), texture_mapping(std::move(mapping))
{
}

void Object::compute_shading_info(Intersection* isect)
{
    Intersection local = locate(*isect);
    local.dudv = glm::vec2(0.f);
    apply_material(&local);
    *isect = to_world_space(local);
}

void Object::compute_shading_info(const Ray rays[4], Intersection* isect)
{
    Intersection local = locate(*isect);
    Ray local_rays[4];
    for (int i = 0; i < 4; ++i)
        local_rays[i] = transform_ray(rays[i], transform_world_to_object);
    local.dudv = compute_uv_aabb_size(local_rays, local);
    apply_material(&local);
    *isect = to_world_space(local);
}

/// The hit in object space, with tangent space and uv where the plan wants them.
Intersection Object::locate(Intersection const& isect) const
{
    Intersection local = transform_intersection(isect, transform_world_to_object, transform_world_to_object_normal);
    RaytracingContext& context = *RaytracingContext::get_active();
    if (context.plan->needs_normal_map(*material)) {
        texture_mapping->compute_tangent_space(&local);
        ++context.stats.tangent_frames;
    }
    if (context.plan->needs_uv(*material))
        local.uv = get_uv(local);
    return local;
}

/// Samples what the plan wants. The shading normal is the normal, unless there is a normal map to follow.
void Object::apply_material(Intersection* isect) const
{
    RaytracingContext& context = *RaytracingContext::get_active();
    isect->shading_normal = isect->normal;
    if (context.plan->shading) {
        isect->material = material->evaluate(isect->uv, isect->dudv);
        ++context.stats.material_samples;
    }
    if (!context.plan->needs_normal_map(*material))
        return;
    ++context.stats.normal_map_lookups;
    isect->material.normal = material->evaluate_normal(isect->uv, isect->dudv);
    isect->shading_normal =
        transform_direction_to_object_space(isect->material.normal, isect->normal, isect->tangent, isect->bitangent);
}

Intersection Object::to_world_space(Intersection const& isect) const
{
    return transform_intersection(isect, transform_object_to_world, transform_object_to_world_normal);
}

glm::vec2 Object::get_uv(Intersection const& isect) const
{
    return texture_mapping->get_uv(isect);
}

void Object::get_intersection_uvs(glm::vec3 const positions[4], Intersection const& isect, glm::vec2 uvs[4]) const
{
    Intersection corner = isect;
    for (int i = 0; i < 4; ++i) {
        corner.position = positions[i];
        uvs[i] = get_uv(corner);
    }
    mend_seam(isect.uv, &uvs[0], &uvs[1]);
    mend_seam(isect.uv, &uvs[2], &uvs[3]);
}

void Object::set_transform_object_to_world(glm::mat4 const& transform)
{
    transform_object_to_world = transform;
    transform_world_to_object = glm::inverse(transform);
    // Directions only: the translation is left out, so that it does not end up in a row of the transposed matrix.
    transform_object_to_world_normal = glm::mat4(glm::transpose(glm::mat3(transform_world_to_object)));
    transform_world_to_object_normal = glm::mat4(glm::transpose(glm::mat3(transform)));
}
