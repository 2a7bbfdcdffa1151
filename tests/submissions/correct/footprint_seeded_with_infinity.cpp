// verdict: {"loses": {}}
// The box starts at infinity.
#include <limits>

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
    constexpr float inf = std::numeric_limits<float>::infinity();
    glm::vec2 lower(inf), upper(-inf);
    std::for_each(uv, uv + 4, [&](glm::vec2 const& p) {
        lower = glm::min(lower, p);
        upper = glm::max(upper, p);
    });
    return upper - lower;
}
