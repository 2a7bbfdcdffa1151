#include <cglib/rt/render_stats.h>

std::vector<RenderCount> const& render_counts()
{
    using S = RenderStats;
    static std::vector<RenderCount> const counts = {
        {"camera rays", &S::camera_rays},
        {"corner rays", &S::corner_rays},
        {"shadow rays", &S::shadow_rays},
        {"reflected rays", &S::reflected_rays},
        {"transmitted rays", &S::transmitted_rays},
        {"object tests", &S::object_tests},
        {"material samples", &S::material_samples},
        {"tangent frames", &S::tangent_frames},
        {"normal-map lookups", &S::normal_map_lookups},
        {"environment lookups", &S::environment_lookups},
        {"mip levels", &S::mip_levels},
        {"textures loaded", &S::textures_loaded},
    };
    return counts;
}

RenderStats& RenderStats::operator+=(RenderStats const& other)
{
    for (RenderCount const& count : render_counts())
        this->*count.value += other.*count.value;
    return *this;
}
