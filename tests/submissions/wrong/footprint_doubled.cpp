// verdict: {"loses": {"compute_uv_aabb_size": [2, 2]}, "says": {"compute_uv_aabb_size": "wrong"}, "policy": [], "mistake": {"compute_uv_aabb_size": "footprint_doubled"}}
// Twice the box.
glm::vec2 Object::compute_uv_aabb_size(const Ray rays[4], Intersection const& isect)
{
    glm::vec3 intersection_positions[4] = {isect.position, isect.position, isect.position, isect.position};
    for (int i = 0; i < 4; ++i) {
        float t;
        if (intersect_plane(rays[i].origin, rays[i].direction, isect.position, isect.normal, &t))
            intersection_positions[i] = rays[i].origin + t * rays[i].direction;
    }

    glm::vec2 intersection_uvs[4];
    get_intersection_uvs(intersection_positions, isect, intersection_uvs);

    glm::vec2 lower = intersection_uvs[0];
    glm::vec2 upper = intersection_uvs[0];
    for (int i = 1; i < 4; ++i) {
        lower = glm::min(lower, intersection_uvs[i]);
        upper = glm::max(upper, intersection_uvs[i]);
    }
    return 2.f * (upper - lower);
}
