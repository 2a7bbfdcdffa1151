#include <cglib/rt/prepared_render.h>

#include "culling.h"

#include <cglib/rt/host_render.h>
#include <cglib/rt/renderer.h>
#include <cglib/rt/sampling_patterns.h>
#include <cglib/rt/scene.h>
#include <cglib/rt/texture_access.h>

#include <algorithm>

namespace {
glm::vec3 render_pixel(RaytracingContext& context, int x, int y, ThreadLocalData& thread)
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

/// True if the texture had no picture and now has one.
bool load(Scene& scene, std::shared_ptr<ImageTexture> const& texture)
{
    auto& levels = TextureAccess::levels(*texture);
    if (!levels.empty())
        return false;
    for (SceneTexture const& entry : scene.textures)
        if (entry.texture == texture && entry.load)
            levels.push_back(entry.load());
    cg_assert(!levels.empty());
    return true;
}

/// How many levels were made.
std::size_t make_mip_levels(ImageTexture& texture)
{
    if (texture.get_mip_levels().size() != 1)
        return 0;
    texture.create_mipmap();
    return std::max<std::size_t>(texture.get_mip_levels().size(), 1) - 1;
}
}  // namespace

PreparedRender::PreparedRender(Scene& scene, RaytracingParameters const& params, bool culling)
    : scene_(scene), params_(params), plan_(plan_render(scene, params))
{
    if (culling)
        culling_ = std::make_unique<Culling>(scene.objects, params.transform_objects);
    RaytracingContext context;
    context.params = params;
    RaytracingContext::Activation const activation(context);
    prepare_textures();
}

PreparedRender::~PreparedRender() = default;

void PreparedRender::prepare_textures()
{
    for (SceneTexture const& entry : scene_.textures) {
        entry.texture->filter_mode = params_.tex_filter_mode;
        entry.texture->wrap_mode = params_.tex_wrap_mode;
    }
    for (std::shared_ptr<ImageTexture> const& texture : plan_.surface_textures) {
        preparation_.textures_loaded += load(scene_, texture) ? 1 : 0;
        if (plan_.mip_levels)
            preparation_.mip_levels += make_mip_levels(*texture);
    }
    if (plan_.environment_texture) {
        preparation_.textures_loaded += load(scene_, plan_.environment_texture) ? 1 : 0;
        plan_.environment_texture->filter_mode = params_.tex_filter_mode == NEAREST ? NEAREST : BILINEAR;
        plan_.environment_texture->wrap_mode = REPEAT;
    }
}

RenderStats PreparedRender::render(Tile const& tile, Image* image) const
{
    RaytracingContext context;
    context.params = params_;
    context.scene = &scene_;
    context.plan = &plan_;
    context.culling = culling_.get();
    RaytracingContext::Activation const activation(context);
    ThreadLocalData thread;
    for (int y = tile.y0; y < tile.y1; ++y)
        for (int x = tile.x0; x < tile.x1; ++x) {
            thread.set_seed(pixel_seed(x, y, params_.width));
            image->setPixel(x, y, glm::vec4(render_pixel(context, x, y, thread), 1.f));
        }
    return context.stats;
}
