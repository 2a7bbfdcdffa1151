// verdict: {"loses": {}}
// Fills a vector of its own and moves it into the level.
void ImageTexture::create_mipmap()
{
    while (mip_levels.back()->getWidth() > 1 || mip_levels.back()->getHeight() > 1) {
        std::shared_ptr<Image> const old = mip_levels.back();
        int const W = old->getWidth(), H = old->getHeight();
        int const w = std::max(W / 2, 1), h = std::max(H / 2, 1);
        int const dx = W > 1 ? 1 : 0, dy = H > 1 ? 1 : 0;
        std::vector<glm::vec4> texels;
        for (int y = 0; y < h; ++y)
            for (int x = 0; x < w; ++x) {
                int const X = W > 1 ? 2 * x : 0, Y = H > 1 ? 2 * y : 0;
                texels.push_back((old->getPixel(X, Y) + old->getPixel(X + dx, Y) + old->getPixel(X, Y + dy) + old->getPixel(X + dx, Y + dy)) * 0.25f);
            }
        auto level = std::make_shared<Image>(w, h);
        level->getPixels() = std::move(texels);
        mip_levels.push_back(level);
    }
}
