// verdict: {"loses": {"compute_uv_aabb_size": [2, 2]}, "says": {"compute_uv_aabb_size": "wrong"}, "policy": []}
// The larger side for both.
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
    glm::vec2 lo = glm::min(glm::min(uv[0], uv[1]), glm::min(uv[2], uv[3]));
    glm::vec2 hi = glm::max(glm::max(uv[0], uv[1]), glm::max(uv[2], uv[3]));
    float size = std::max(hi.x - lo.x, hi.y - lo.y);
    return glm::vec2(size, size);
}
