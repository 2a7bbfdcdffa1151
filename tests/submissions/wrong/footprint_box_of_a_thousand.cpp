// verdict: {"loses": {"compute_uv_aabb_size": [0.5, 0.5]}, "says": {"compute_uv_aabb_size": "partial"}, "policy": []}
// The box begins as one that seems large enough.
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
    glm::vec2 lower(1000);
    glm::vec2 upper(-1000);
    for (glm::vec2 const& uv : uvs) {
        lower = glm::min(lower, uv);
        upper = glm::max(upper, uv);
    }
    return upper - lower;
}
