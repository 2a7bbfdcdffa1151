#include <cglib/rt/raytracing_parameters.h>

namespace {
bool filters_mip_levels(RaytracingParameters const& params)
{
    return params.tex_filter_mode == TRILINEAR || params.tex_filter_mode == DEBUG_MIP;
}
}  // namespace

bool needs_materials(RaytracingParameters const& params)
{
    return params.render_mode != NORMAL && params.render_mode != DUDV;
}

bool needs_textures(RaytracingParameters const& params)
{
    return needs_materials(params) || (params.render_mode == NORMAL && params.normal_mapping);
}

bool needs_footprints(RaytracingParameters const& params)
{
    return filters_mip_levels(params) && (params.render_mode == DUDV || needs_textures(params));
}

bool needs_mip_levels(RaytracingParameters const& params)
{
    return filters_mip_levels(params) && needs_textures(params);
}
