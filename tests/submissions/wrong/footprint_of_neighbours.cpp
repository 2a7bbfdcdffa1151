// verdict: {"loses": {"compute_uv_aabb_size": [1.0, 1.0]}, "says": {"compute_uv_aabb_size": "partial"}, "policy": [], "mistake": {"compute_uv_aabb_size": "footprint_of_neighbours"}}
// Differences to the first corner instead of a box around all four.
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
    return glm::max(glm::abs(uvs[1] - uvs[0]), glm::max(glm::abs(uvs[2] - uvs[0]), glm::abs(uvs[3] - uvs[0])));
}
