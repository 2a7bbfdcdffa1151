#include <cglib/rt/render_plan.h>

#include <cglib/rt/scene.h>

#include <algorithm>

namespace {
using Textures = std::vector<std::shared_ptr<ImageTexture>>;

bool filters_mip_levels(RaytracingParameters const& params)
{
    return params.tex_filter_mode == TRILINEAR || params.tex_filter_mode == DEBUG_MIP;
}

template <class Predicate>
bool any_material(Scene const& scene, Predicate const& predicate)
{
    return std::any_of(scene.objects.begin(), scene.objects.end(),
                       [&](std::shared_ptr<Object> const& object) { return predicate(*object->material); });
}

/// Whether the coefficient is a constant zero.
bool is_absent(std::shared_ptr<Texture> const& coefficient)
{
    return !coefficient->depends_on_uv() && glm::vec3(coefficient->evaluate(glm::vec2(0.f))) == glm::vec3(0.f);
}

bool reflects(Material const& material)
{
    return !is_absent(material.k_r);
}

bool transmits(Material const& material)
{
    return !is_absent(material.k_t);
}

void add(std::shared_ptr<Texture> const& texture, Textures* textures)
{
    auto image = std::dynamic_pointer_cast<ImageTexture>(texture);
    if (image && std::find(textures->begin(), textures->end(), image) == textures->end())
        textures->push_back(std::move(image));
}

Textures looked_up(Scene const& scene, RenderPlan const& plan)
{
    Textures textures;
    for (std::shared_ptr<Object> const& object : scene.objects) {
        Material const& material = *object->material;
        if (plan.shading)
            for (auto const* k : {&material.k_a, &material.k_d, &material.k_s, &material.k_r, &material.k_t})
                add(*k, &textures);
        if (plan.needs_normal_map(material))
            add(material.normal, &textures);
    }
    return textures;
}
}  // namespace

RenderPlan plan_render(Scene const& scene, RaytracingParameters const& params)
{
    bool const mips = filters_mip_levels(params);
    RenderPlan plan;
    plan.texels = params.tex_filter_mode != WHITE;
    plan.shading = params.render_mode != NORMAL && params.render_mode != DUDV;
    plan.normal_maps = params.normal_mapping && params.render_mode != DUDV &&
                       any_material(scene, [](Material const& m) { return m.has_normal_map(); });
    if (plan.texels)
        plan.surface_textures = looked_up(scene, plan);
    plan.mip_levels = mips && !plan.surface_textures.empty();
    plan.footprints_shown = mips && params.render_mode == DUDV;
    plan.footprints = plan.mip_levels || plan.footprints_shown;
    plan.shadow_rays = plan.shading && params.shadows && (params.diffuse || params.specular) && !scene.lights.empty();
    plan.reflected_rays = plan.shading && params.reflection && params.max_depth >= 1 &&
                          any_material(scene, [](Material const& m) { return reflects(m) || transmits(m); });
    plan.transmitted_rays =
        plan.shading && params.transmission && params.max_depth >= 1 && any_material(scene, transmits);
    plan.environment = plan.shading && scene.environment;
    plan.environment_texture = plan.environment ? scene.environment : nullptr;
    return plan;
}

bool RenderPlan::needs_footprint(Material const& material) const
{
    return footprints_shown || (footprints && needs_uv(material));
}

bool RenderPlan::needs_uv(Material const& material) const
{
    return footprints_shown || (texels && ((shading && material.is_textured()) || needs_normal_map(material)));
}

bool RenderPlan::needs_normal_map(Material const& material) const
{
    return normal_maps && material.has_normal_map();
}
