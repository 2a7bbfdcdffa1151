// verdict: {"loses": {}}
// Looks at t instead of at what intersect_plane returns.
glm::vec2 Object::
compute_uv_aabb_size(const Ray rays[4], Intersection const& isect)
{
    glm::vec3 intersection_positions[4] = {
        isect.position, isect.position, isect.position, isect.position
    };
    for (int i = 0; i < 4; ++i) {
        float t = -1;
        intersect_plane(rays[i].origin, rays[i].direction, isect.position, isect.normal, &t);
        if (t > 0)
            intersection_positions[i] = rays[i].origin + rays[i].direction * t;
    }
    glm::vec2 intersection_uvs[4];
    get_intersection_uvs(intersection_positions, isect, intersection_uvs);
    float minu = INFINITY, minv = INFINITY, maxu = -INFINITY, maxv = -INFINITY;
    for (auto& uv : intersection_uvs) {
        minu = fmin(minu, uv.x); maxu = fmax(maxu, uv.x);
        minv = fmin(minv, uv.y); maxv = fmax(maxv, uv.y);
    }
    return glm::vec2(maxu - minu, maxv - minv);
}
