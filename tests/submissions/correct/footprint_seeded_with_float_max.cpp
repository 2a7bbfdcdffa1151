// verdict: {"loses": {}}
// The box starts inside out.
#include <cfloat>

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
    float u0 = FLT_MAX, u1 = -FLT_MAX, v0 = FLT_MAX, v1 = -FLT_MAX;
    for (int i = 0; i < 4; i++) {
        if (uv[i].x < u0) u0 = uv[i].x;
        if (uv[i].x > u1) u1 = uv[i].x;
        if (uv[i].y < v0) v0 = uv[i].y;
        if (uv[i].y > v1) v1 = uv[i].y;
    }
    return glm::vec2(u1 - u0, v1 - v0);
}
