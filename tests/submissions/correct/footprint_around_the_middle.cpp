// verdict: {"loses": {}}
// The box begins at isect.uv, which lies inside it anyway.
glm::vec2 Object::
compute_uv_aabb_size(const Ray rays[4], Intersection const& isect)
{
    glm::vec3 intersection_positions[4] = {
        isect.position, isect.position, isect.position, isect.position
    };
    for (int i = 0; i < 4; ++i) {
        float t = 0;
        if (intersect_plane(rays[i].origin, rays[i].direction, isect.position, isect.normal, &t))
            intersection_positions[i] = rays[i].origin + rays[i].direction * t;
    }
    glm::vec2 intersection_uvs[4];
    get_intersection_uvs(intersection_positions, isect, intersection_uvs);
    glm::vec2 lo = isect.uv, hi = isect.uv;
    for (int i = 0; i < 4; ++i) { lo = glm::min(lo, intersection_uvs[i]); hi = glm::max(hi, intersection_uvs[i]); }
    return hi - lo;
}
