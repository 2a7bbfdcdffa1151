// verdict: {"loses": {"compute_uv_aabb_size": [0.25, 1]}, "says": {"compute_uv_aabb_size": "partial"}, "policy": [], "remarks": ["differs_between_runs"]}
// Uninitialised read: the position of a ray that misses is whatever the stack held.
glm::vec2 Object::compute_uv_aabb_size(const Ray rays[4], Intersection const& isect)
{
    glm::vec3 positions[4];
    for (int i = 0; i < 4; ++i) {
        float t;
        if (intersect_plane(rays[i].origin, rays[i].direction, isect.position, isect.normal, &t))
            positions[i] = rays[i].origin + t * rays[i].direction;
    }
    glm::vec2 uvs[4];
    get_intersection_uvs(positions, isect, uvs);
    glm::vec2 lower = uvs[0];
    glm::vec2 upper = uvs[0];
    for (int i = 1; i < 4; ++i) {
        lower = glm::min(lower, uvs[i]);
        upper = glm::max(upper, uvs[i]);
    }
    return upper - lower;
}
