// verdict: {"loses": {"create_mipmap": [1, 2]}, "says": {"create_mipmap": "partial"}, "policy": [], "mistake": {"create_mipmap": "mipmap_loses_alpha"}}
// Averages three components of four.
void ImageTexture::create_mipmap()
{
    while (mip_levels.back()->getWidth() > 1 || mip_levels.back()->getHeight() > 1) {
        Image const& finer = *mip_levels.back();
        int const w = std::max(finer.getWidth() / 2, 1), h = std::max(finer.getHeight() / 2, 1);
        auto const coarser = std::make_shared<Image>(w, h);
        for (int y = 0; y < h; y++)
            for (int x = 0; x < w; x++) {
                int const x0 = 2 * x, x1 = std::min(2 * x + 1, finer.getWidth() - 1);
                int const y0 = 2 * y, y1 = std::min(2 * y + 1, finer.getHeight() - 1);
                glm::vec4 const sum =
                    finer.getPixel(x0, y0) + finer.getPixel(x1, y0) + finer.getPixel(x0, y1) + finer.getPixel(x1, y1);
                coarser->setPixel(x, y, glm::vec4(glm::vec3(sum) / 4.f, 1.f));
            }
        mip_levels.push_back(coarser);
    }
}
