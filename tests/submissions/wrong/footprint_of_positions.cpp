// verdict: {"loses": {"compute_uv_aabb_size": [2, 2]}, "says": {"compute_uv_aabb_size": "wrong"}, "policy": [], "mistake": {"compute_uv_aabb_size": "footprint_of_positions"}}
// The box around the positions instead of around the uv.
glm::vec2 Object::compute_uv_aabb_size(const Ray rays[4], Intersection const& isect)
{
    glm::vec3 positions[4] = {isect.position, isect.position, isect.position, isect.position};
    for (int i = 0; i < 4; ++i) {
        float t;
        if (intersect_plane(rays[i].origin, rays[i].direction, isect.position, isect.normal, &t))
            positions[i] = rays[i].origin + t * rays[i].direction;
    }
    glm::vec2 uvs[4];
    get_intersection_uvs(positions, isect, uvs);
    glm::vec3 lower = positions[0];
    glm::vec3 upper = positions[0];
    for (int i = 1; i < 4; ++i) {
        lower = glm::min(lower, positions[i]);
        upper = glm::max(upper, positions[i]);
    }
    return glm::vec2(upper.x - lower.x, upper.z - lower.z);
}
