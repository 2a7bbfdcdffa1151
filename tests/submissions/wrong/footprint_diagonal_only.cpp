// verdict: {"loses": {"compute_uv_aabb_size": [1, 1]}, "says": {"compute_uv_aabb_size": "partial"}, "policy": [], "mistake": {"compute_uv_aabb_size": "footprint_forgets_a_corner"}}
// The two corners of one diagonal: right as long as the pixel is not rotated.
glm::vec2 Object::compute_uv_aabb_size(const Ray rays[4], Intersection const& isect)
{
    glm::vec3 p[4] = {isect.position, isect.position, isect.position, isect.position};
    for (int i = 0; i < 4; i++) {
        float t = 0.f;
        if (intersect_plane(rays[i].origin, rays[i].direction, isect.position, isect.normal, &t))
            p[i] = rays[i].origin + t * rays[i].direction;
    }
    glm::vec2 uv[4];
    get_intersection_uvs(p, isect, uv);
    return glm::abs(uv[1] - uv[0]);
}
