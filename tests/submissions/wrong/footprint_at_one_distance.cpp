// verdict: {"loses": {"compute_uv_aabb_size": [2, 2]}, "says": {"compute_uv_aabb_size": "wrong"}, "policy": []}
// All corners at the distance of the hit: on a sphere around the eye instead of in the plane.
glm::vec2 Object::compute_uv_aabb_size(const Ray rays[4], Intersection const& isect)
{
    glm::vec3 p[4] = {isect.position, isect.position, isect.position, isect.position};
    for (int i = 0; i < 4; i++) {
        float t = 0.f;
        t = isect.t;
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
