// verdict: {"broken": {"compute_uv_aabb_size": "compute_uv_aabb_size(glm::vec3 const*"}, "unofficial": [18, 18]}
// A member that its class does not declare.
glm::vec2 Object::compute_uv_aabb_size(glm::vec3 const* positions, Intersection const& isect)
{
    glm::vec2 uvs[4];
    get_intersection_uvs(positions, isect, uvs);
    return glm::max(uvs[0], uvs[1]) - glm::min(uvs[0], uvs[1]);
}
