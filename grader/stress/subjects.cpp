#include "stress/subjects.h"

namespace testat {
std::vector<Subject> const& subjects()
{
    constexpr std::uint32_t mebi = most_questions;
    static std::vector<Subject> const all = {
        {Function::evaluate_nearest, mebi, texels_inside, lookups_outside, nearest_deviation},
        {Function::wrap_clamp, mebi, wraps_inside, wraps_outside, wrap_clamp_deviation},
        {Function::wrap_repeat, mebi, wraps_inside, wraps_outside, wrap_repeat_deviation},
        {Function::evaluate_bilinear, mebi, lookups_inside, lookups_outside, bilinear_deviation},
        {Function::create_mipmap, 2048, mipmaps_inside, mipmaps_outside, mipmap_deviation, 64},
        {Function::compute_uv_aabb_size, mebi / 2, footprints_inside, footprints_outside, footprint_deviation},
        {Function::evaluate_trilinear, mebi / 2, filtered_inside, filtered_outside, trilinear_deviation},
        {Function::transform_direction, mebi, directions_inside, directions_outside, direction_deviation},
        {Function::transform_position, mebi, positions_inside, positions_outside, position_deviation},
        {Function::intersect, mebi / 2, hits_inside, hits_outside, intersect_deviation},
        {Function::transform_direction_to_object_space, mebi, frames_inside, frames_outside, tangent_space_deviation},
    };
    return all;
}
}  // namespace testat
