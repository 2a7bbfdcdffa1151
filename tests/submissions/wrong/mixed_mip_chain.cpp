// verdict: {"loses": {"evaluate_bilinear": [3, 3], "create_mipmap": [1.5, 1.5], "compute_uv_aabb_size": [1, 1], "evaluate_trilinear": [0.75, 0.75]}, "says": {"evaluate_bilinear": "partial", "create_mipmap": "partial", "compute_uv_aabb_size": "partial", "evaluate_trilinear": "crashed"}, "policy": ["crashes"], "by_hand": 13.75, "mistake": {"evaluate_bilinear": "bilinear_one_axis", "create_mipmap": "mipmap_misses_last_row", "compute_uv_aabb_size": "footprint_of_the_object", "evaluate_trilinear": "trilinear_not_clamped_below"}, "sanitizers": false}
// By GRADING's table of mistakes, the middle where it gives a range:
// evaluate_bilinear interpolates along one axis only: 3 of 4. create_mipmap leaves out the last row and column: 1.5 of 2.
// compute_uv_aabb_size meets the object instead of its tangent plane: 1 of 2. evaluate_trilinear is not clamped at one
// end: 0.5 to 1 of 2.
// 20 - 3 - 1.5 - 1 - 0.75 = 13.75
glm::vec4 ImageTexture::evaluate_bilinear(int level, glm::vec2 const& uv) const
{
    Image const& image = *mip_levels[level];
    float s = uv.x * image.getWidth() - 0.5f;
    int x = (int)std::floor(s);
    int y = (int)std::floor(uv.y * image.getHeight());
    return glm::mix(get_texel(level, x, y), get_texel(level, x + 1, y), s - x);
}

void ImageTexture::create_mipmap()
{
    int width = mip_levels[0]->getWidth();
    int height = mip_levels[0]->getHeight();
    while (width > 1 || height > 1) {
        std::shared_ptr<Image> finer = mip_levels.back();
        width = std::max(1, width / 2);
        height = std::max(1, height / 2);
        int const step_x = finer->getWidth() / width;
        int const step_y = finer->getHeight() / height;
        auto coarser = std::make_shared<Image>(width, height);
        for (int y = 0; y < height - 1; ++y)
            for (int x = 0; x < width - 1; ++x) {
                glm::vec4 sum(0.f);
                for (int j = 0; j < step_y; ++j)
                    for (int i = 0; i < step_x; ++i)
                        sum += finer->getPixel(x * step_x + i, y * step_y + j);
                coarser->setPixel(x, y, sum / float(step_x * step_y));
            }
        mip_levels.push_back(coarser);
    }
}

glm::vec2 Object::compute_uv_aabb_size(const Ray rays[4], Intersection const& isect)
{
    glm::vec3 positions[4];
    for (int i = 0; i < 4; ++i) {
        Intersection corner;
        positions[i] = geo->intersect(rays[i], &corner) ? corner.position : isect.position;
    }
    glm::vec2 uvs[4];
    get_intersection_uvs(positions, isect, uvs);
    glm::vec2 const lower = glm::min(glm::min(uvs[0], uvs[1]), glm::min(uvs[2], uvs[3]));
    glm::vec2 const upper = glm::max(glm::max(uvs[0], uvs[1]), glm::max(uvs[2], uvs[3]));
    return upper - lower;
}

glm::vec4 ImageTexture::evaluate_trilinear(glm::vec2 const& uv, glm::vec2 const& dudv) const
{
    int const last = int(mip_levels.size()) - 1;
    float const width = float(mip_levels[0]->getWidth());
    float const height = float(mip_levels[0]->getHeight());
    float const S = std::max(dudv.x * width, dudv.y * height);
    float const T = std::log2(S);
    if (T >= float(last))
        return evaluate_bilinear(last, uv);
    int const finer = int(std::floor(T));
    return glm::mix(evaluate_bilinear(finer, uv), evaluate_bilinear(finer + 1, uv), T - float(finer));
}
