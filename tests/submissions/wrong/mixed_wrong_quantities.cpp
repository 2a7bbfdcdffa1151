// verdict: {"loses": {"wrap_repeat": [0.5, 0.5], "compute_uv_aabb_size": [2, 2], "transform_direction": [0.5, 0.5]}, "says": {"wrap_repeat": "partial", "compute_uv_aabb_size": "wrong", "transform_direction": "partial"}, "policy": [], "by_hand": 17.5, "mistake": {"wrap_repeat": "repeat_one_too_low", "compute_uv_aabb_size": "footprint_of_positions", "transform_direction": "direction_not_normalised"}}
// By GRADING's table of mistakes, the middle where it gives a range:
// wrap_repeat is n - 1 + v % n: 0.5 of 1. compute_uv_aabb_size is the box of positions: 1 to 2 of 2. transform_direction does
// not normalise: 0.5 of 1.
// 20 - 0.5 - 1.5 - 0.5 = 17.5
int ImageTexture::wrap_repeat(int val, int size)
{
    if (val < 0)
        return size - 1 + val % size;
    return val % size;
}

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
    glm::vec3 lower = positions[0];
    glm::vec3 upper = positions[0];
    for (int i = 1; i < 4; ++i) {
        lower = glm::min(lower, positions[i]);
        upper = glm::max(upper, positions[i]);
    }
    return glm::vec2(upper.x - lower.x, upper.z - lower.z);
}

glm::vec3 transform_direction(glm::mat4 const& transform, glm::vec3 const& d)
{
    return glm::vec3(transform * glm::vec4(d, 0.f));
}
