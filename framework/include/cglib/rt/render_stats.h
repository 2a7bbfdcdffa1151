#pragma once

#include <cstdint>
#include <vector>

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

/// One of the counts, and what people call it.
struct RenderCount {
    char const* name;
    std::uint64_t RenderStats::*value;
};

/// All of them, in the order above.
std::vector<RenderCount> const& render_counts();

/// Calls visit(name, count) for each count, in the order above.
template <class Visitor>
void visit_stats(RenderStats const& stats, Visitor const& visit)
{
    for (RenderCount const& count : render_counts())
        visit(count.name, stats.*count.value);
}
