// verdict: {"loses": {"create_mipmap": [1, 1]}, "says": {"create_mipmap": "partial"}, "policy": []}
// Colours above 1 are cut off.
void ImageTexture::create_mipmap()
{
    mip_levels.resize(1);
    while (mip_levels.back()->getWidth() > 1 || mip_levels.back()->getHeight() > 1) {
        Image const& finer = *mip_levels.back();
        int const width = std::max(1, finer.getWidth() / 2);
        int const height = std::max(1, finer.getHeight() / 2);
        // A side that is one texel long already is not halved: its blocks are one texel wide.
        int const step_x = finer.getWidth() / width;
        int const step_y = finer.getHeight() / height;

        auto coarser = std::make_shared<Image>(width, height);
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                glm::vec4 sum(0.f);
                for (int j = 0; j < step_y; ++j)
                    for (int i = 0; i < step_x; ++i)
                        sum += finer.getPixel(x * step_x + i, y * step_y + j);
                coarser->setPixel(x, y, glm::clamp(sum / float(step_x * step_y), 0.f, 1.f));
            }
        }
        mip_levels.push_back(coarser);
    }
}
