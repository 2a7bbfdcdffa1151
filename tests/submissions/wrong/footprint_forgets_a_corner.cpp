// verdict: {"loses": {"compute_uv_aabb_size": [1.0, 1.0]}, "says": {"compute_uv_aabb_size": "partial"}, "policy": [], "mistake": {"compute_uv_aabb_size": "footprint_forgets_a_corner"}}
// The box around three corners.
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
    glm::vec2 lower = uvs[0];
    glm::vec2 upper = uvs[0];
    for (int i = 1; i < 3; ++i) {
        lower = glm::min(lower, uvs[i]);
        upper = glm::max(upper, uvs[i]);
    }
    return upper - lower;
}
