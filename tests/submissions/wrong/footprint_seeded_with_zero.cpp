// verdict: {"loses": {"compute_uv_aabb_size": [2, 2]}, "says": {"compute_uv_aabb_size": "wrong"}, "policy": [], "mistake": {"compute_uv_aabb_size": "footprint_seeded_with_zero"}}
// The box starts with the point (0, 0) in it.
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
    glm::vec2 lower(0.f);
    glm::vec2 upper(0.f);
    for (auto const& corner : uvs) {
        lower = glm::min(lower, corner);
        upper = glm::max(upper, corner);
    }
    return upper - lower;
}
