// verdict: {"loses": {"evaluate_nearest": [1, 1.5], "wrap_repeat": [0.5, 0.5], "evaluate_bilinear": [1.0, 1.0], "compute_uv_aabb_size": [1.0, 1.0], "transform_direction": [0.5, 0.5]}, "says": {"evaluate_nearest": "partial", "wrap_repeat": "partial", "evaluate_bilinear": "partial", "compute_uv_aabb_size": "partial", "transform_direction": "partial"}, "policy": [], "by_hand": 15.75, "mistake": {"wrap_repeat": "repeat_one_too_low", "evaluate_bilinear": "bilinear_casts", "compute_uv_aabb_size": "footprint_of_neighbours", "transform_direction": "direction_not_normalised"}}
// By GRADING's table of mistakes, the middle where it gives a range:
// evaluate_nearest takes level 0's size for every level (0.5 to 1 of 2) and casts (0.5 to 1 of 2): 1.5. wrap_repeat is
// n - 1 + v % n: 0.5 of 1. evaluate_bilinear casts: 1 of 4. compute_uv_aabb_size takes differences of neighbours: 0.5 to 1
// of 2. transform_direction does not normalise: 0.5 of 1.
// 20 - 1.5 - 0.5 - 1 - 0.75 - 0.5 = 15.75
glm::vec4 ImageTexture::evaluate_nearest(int level, glm::vec2 const& uv) const
{
    int x = (int)(uv.x * mip_levels[0]->getWidth());
    int y = (int)(uv.y * mip_levels[0]->getHeight());
    return get_texel(level, x, y);
}

int ImageTexture::wrap_repeat(int val, int size)
{
    if (val < 0)
        return size - 1 + val % size;
    return val % size;
}

glm::vec4 ImageTexture::evaluate_bilinear(int level, glm::vec2 const& uv) const
{
    Image const& image = *mip_levels[level];
    float s = uv.x * image.getWidth() - 0.5f;
    float t = uv.y * image.getHeight() - 0.5f;
    int x = (int)s;
    int y = (int)t;
    glm::vec4 lower = glm::mix(get_texel(level, x, y), get_texel(level, x + 1, y), s - x);
    glm::vec4 upper = glm::mix(get_texel(level, x, y + 1), get_texel(level, x + 1, y + 1), s - x);
    return glm::mix(lower, upper, t - y);
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
    return glm::max(glm::abs(uvs[1] - uvs[0]), glm::max(glm::abs(uvs[2] - uvs[0]), glm::abs(uvs[3] - uvs[0])));
}

glm::vec3 transform_direction(glm::mat4 const& transform, glm::vec3 const& d)
{
    return glm::vec3(transform * glm::vec4(d, 0.f));
}
