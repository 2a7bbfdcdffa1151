#pragma once

#include <cglib/rt/raytracing_parameters.h>

#include <memory>
#include <vector>

class ImageTexture;
class Material;
struct Scene;

/// What a picture needs, decided before its first pixel from mode, filter, scene and materials. Whatever is false here
/// is not computed at all. By default what default parameters need of a scene that has everything.
struct RenderPlan {
    /// Hits are shaded: materials are sampled, lights are looked at.
    bool shading = true;
    /// Textures are looked up. False for a filter that makes all of them white.
    bool texels = true;
    /// Hits of textured materials need dudv: rays go through the corners of their pixels.
    bool footprints = false;
    /// Every hit needs dudv, textured or not, because dudv is what is shown.
    bool footprints_shown = false;
    /// Hits of materials with a normal map need a tangent space and a lookup.
    bool normal_maps = false;
    /// Textures are read at levels other than 0.
    bool mip_levels = false;

    bool shadow_rays = true;
    bool reflected_rays = true;
    bool transmitted_rays = true;
    /// Rays that hit nothing look up the environment.
    bool environment = true;

    /// Those that are looked up: on surfaces, and in the environment (null if nothing is).
    std::vector<std::shared_ptr<ImageTexture>> surface_textures;
    std::shared_ptr<ImageTexture> environment_texture;

    /// Whether a hit of this material needs dudv.
    bool needs_footprint(Material const& material) const;
    /// Whether a hit of this material needs uv.
    bool needs_uv(Material const& material) const;
    /// Whether a hit of this material needs a tangent space and its normal map.
    bool needs_normal_map(Material const& material) const;
};

/// Never throws for a scene whose materials are complete.
RenderPlan plan_render(Scene const& scene, RaytracingParameters const& params);
