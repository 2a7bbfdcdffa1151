#include <cglib/rt/render_stats.h>

RenderStats& RenderStats::operator+=(RenderStats const& other)
{
    camera_rays += other.camera_rays;
    corner_rays += other.corner_rays;
    shadow_rays += other.shadow_rays;
    reflected_rays += other.reflected_rays;
    transmitted_rays += other.transmitted_rays;
    object_tests += other.object_tests;
    material_samples += other.material_samples;
    tangent_frames += other.tangent_frames;
    normal_map_lookups += other.normal_map_lookups;
    environment_lookups += other.environment_lookups;
    mip_levels += other.mip_levels;
    textures_loaded += other.textures_loaded;
    return *this;
}
