#pragma once

#include <cstdint>

/// What was done for a picture. Sums are the same whatever the number of threads.
struct RenderStats {
    std::uint64_t camera_rays = 0;
    /// Through the corners of pixels, four for each footprint.
    std::uint64_t corner_rays = 0;
    std::uint64_t shadow_rays = 0;
    std::uint64_t reflected_rays = 0;
    std::uint64_t transmitted_rays = 0;

    /// Calls of Object::intersect.
    std::uint64_t object_tests = 0;

    /// Hits whose material was sampled.
    std::uint64_t material_samples = 0;
    /// Hits for which a tangent space was made.
    std::uint64_t tangent_frames = 0;
    std::uint64_t normal_map_lookups = 0;
    std::uint64_t environment_lookups = 0;

    /// Levels beyond level 0 that create_mipmap has made.
    std::uint64_t mip_levels = 0;
    /// Image textures whose level 0 was loaded for this picture.
    std::uint64_t textures_loaded = 0;

    RenderStats& operator+=(RenderStats const& other);
};

/// Calls visit(name, count) for each count, in the order above.
template <class Visitor>
void visit_stats(RenderStats const& stats, Visitor const& visit)
{
    visit("camera rays", stats.camera_rays);
    visit("corner rays", stats.corner_rays);
    visit("shadow rays", stats.shadow_rays);
    visit("reflected rays", stats.reflected_rays);
    visit("transmitted rays", stats.transmitted_rays);
    visit("object tests", stats.object_tests);
    visit("material samples", stats.material_samples);
    visit("tangent frames", stats.tangent_frames);
    visit("normal-map lookups", stats.normal_map_lookups);
    visit("environment lookups", stats.environment_lookups);
    visit("mip levels", stats.mip_levels);
    visit("textures loaded", stats.textures_loaded);
}
