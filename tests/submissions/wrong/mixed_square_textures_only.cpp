// verdict: {"loses": {"evaluate_nearest": [1, 1.5], "create_mipmap": [1, 1], "evaluate_trilinear": [0.5, 0.5]}, "says": {"evaluate_nearest": "partial", "create_mipmap": "partial", "evaluate_trilinear": "crashed"}, "policy": [], "by_hand": 17.25, "mistake": {"evaluate_nearest": "nearest_swaps_width_and_height", "create_mipmap": "mipmap_stops_at_shorter_side", "evaluate_trilinear": "trilinear_crashes_at_last_level"}, "sanitizers": false}
// By GRADING's table of mistakes, the middle where it gives a range:
// evaluate_nearest swaps W and H: 1 to 1.5 of 2. create_mipmap stops at the shorter side: 1 of 2. evaluate_trilinear crashes
// at S = 2^last: 0.5 of 2.
// 20 - 1.25 - 1 - 0.5 = 17.25
glm::vec4 ImageTexture::evaluate_nearest(int level, glm::vec2 const& uv) const
{
    int x = (int)std::floor(uv.x * mip_levels[level]->getHeight());
    int y = (int)std::floor(uv.y * mip_levels[level]->getWidth());
    return get_texel(level, x, y);
}

void ImageTexture::create_mipmap()
{
    int width = mip_levels[0]->getWidth();
    int height = mip_levels[0]->getHeight();
    while (width > 1 && height > 1) {
        std::shared_ptr<Image> finer = mip_levels.back();
        width = std::max(1, width / 2);
        height = std::max(1, height / 2);
        int const step_x = finer->getWidth() / width;
        int const step_y = finer->getHeight() / height;
        auto coarser = std::make_shared<Image>(width, height);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                glm::vec4 sum(0.f);
                for (int j = 0; j < step_y; ++j)
                    for (int i = 0; i < step_x; ++i)
                        sum += finer->getPixel(x * step_x + i, y * step_y + j);
                coarser->setPixel(x, y, sum / float(step_x * step_y));
            }
        mip_levels.push_back(coarser);
    }
}

glm::vec4 ImageTexture::evaluate_trilinear(glm::vec2 const& uv, glm::vec2 const& dudv) const
{
    int const last = int(mip_levels.size()) - 1;
    float const width = float(mip_levels[0]->getWidth());
    float const height = float(mip_levels[0]->getHeight());
    float const S = std::max(dudv.x * width, dudv.y * height);
    if (!(S > 1.f))
        return evaluate_bilinear(0, uv);
    float const T = std::log2(S);
    if (T > float(last))
        return evaluate_bilinear(last, uv);
    int const finer = int(std::floor(T));
    return glm::mix(evaluate_bilinear(finer, uv), evaluate_bilinear(finer + 1, uv), T - float(finer));
}
