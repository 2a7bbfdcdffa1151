// verdict: {"loses": {}}
// using namespace std and glm, and includes that nobody needs.
#include <iostream>
#include <string>

using namespace std;
using namespace glm;

vec4 ImageTexture::evaluate_nearest(int level, vec2 const& uv) const
{
    vec2 st = floor(uv * vec2(mip_levels[level]->getWidth(), mip_levels[level]->getHeight()));
    return get_texel(level, int(st.x), int(st.y));
}

int ImageTexture::wrap_clamp(int val, int size) { return std::min(std::max(0, val), size - 1); }

vec3 transform_direction(mat4 const& transform, vec3 const& d) { return normalize(vec3(transform * vec4(d, 0))); }

vec3 transform_position(mat4 const& transform, vec3 const& p) { return vec3(transform * vec4(p, 1)); }

vec3 transform_direction_to_object_space(vec3 const& d, vec3 const& normal, vec3 const& tangent, vec3 const& bitangent)
{
    mat3 tangent_to_object(tangent, normal, bitangent);
    return normalize(tangent_to_object * d);
}
