// verdict: {"loses": {"compute_uv_aabb_size": [0.25, 0.25]}, "says": {"compute_uv_aabb_size": "partial"}, "policy": []}
// The first ray is taken to hit whatever intersect_plane says: wrong only where all four miss.
glm::vec2 Object::compute_uv_aabb_size(const Ray rays[4], Intersection const& isect)
{
    glm::vec3 p[4] = {isect.position, isect.position, isect.position, isect.position};
    for (int i = 0; i < 4; i++) {
        float t = 0.f;
        if (intersect_plane(rays[i].origin, rays[i].direction, isect.position, isect.normal, &t) || i == 0)
            p[i] = rays[i].origin + t * rays[i].direction;
    }
    glm::vec2 uv[4];
    get_intersection_uvs(p, isect, uv);
    glm::vec2 lo = uv[0], hi = uv[0];
    for (int i = 1; i < 4; i++) {
        lo = glm::min(lo, uv[i]);
        hi = glm::max(hi, uv[i]);
    }
    return hi - lo;
}
