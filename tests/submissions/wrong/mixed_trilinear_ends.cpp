// verdict: {"loses": {"wrap_repeat": [0.5, 0.5], "create_mipmap": [1, 1], "evaluate_trilinear": [0.75, 1]}, "says": {"wrap_repeat": "crashed", "create_mipmap": "partial", "evaluate_trilinear": "crashed"}, "policy": ["crashes"], "by_hand": 17.5, "mistake": {"wrap_repeat": "repeat_off_at_multiples", "create_mipmap": "mipmap_stops_at_shorter_side"}}
// By GRADING's table of mistakes, the middle where it gives a range:
// wrap_repeat is wrong at negative multiples: 0.5 of 1. create_mipmap stops at the shorter side: 1 of 2. evaluate_trilinear
// is NaN at dudv = 0 (0.5 of 2) and crashes at S = 2^last (0.5 of 2): 1.
// 20 - 0.5 - 1 - 1 = 17.5
int ImageTexture::wrap_repeat(int val, int size)
{
    if (val < 0)
        return size - (-val % size);
    return val % size;
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
    float const S = std::max(dudv.x * mip_levels[0]->getWidth(), dudv.y * mip_levels[0]->getHeight());
    float const T = std::log2(S);
    if (T > last)
        return evaluate_bilinear(last, uv);
    int finer = T > 0.f ? (int)std::floor(T) : 0;
    int coarser = T > 0.f ? finer + 1 : 0;
    return glm::mix(evaluate_bilinear(finer, uv), evaluate_bilinear(coarser, uv), T - std::floor(T));
}
