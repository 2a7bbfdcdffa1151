// verdict: {"loses": {}}
// std::max of initializer lists.
glm::vec2 Object::compute_uv_aabb_size(const Ray rays[4], Intersection const& isect)
{
    glm::vec3 positions[4];
    for (int i = 0; i < 4; ++i) {
        float t = 0;
        bool hit = intersect_plane(rays[i].origin, rays[i].direction, isect.position, isect.normal, &t);
        positions[i] = hit ? rays[i].origin + rays[i].direction * t : isect.position;
    }
    glm::vec2 uv[4];
    get_intersection_uvs(positions, isect, uv);
    float du = std::max({uv[0].x, uv[1].x, uv[2].x, uv[3].x}) - std::min({uv[0].x, uv[1].x, uv[2].x, uv[3].x});
    float dv = std::max({uv[0].y, uv[1].y, uv[2].y, uv[3].y}) - std::min({uv[0].y, uv[1].y, uv[2].y, uv[3].y});
    return {du, dv};
}
