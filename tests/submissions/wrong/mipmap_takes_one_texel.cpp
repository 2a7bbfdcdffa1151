// verdict: {"loses": {"create_mipmap": [1.5, 1.5]}, "says": {"create_mipmap": "partial"}, "policy": [], "mistake": {"create_mipmap": "mipmap_takes_one_texel"}}
// Every second texel of the level before, no average: it flickers as before.
void ImageTexture::create_mipmap()
{
    int width = mip_levels[0]->getWidth();
    int height = mip_levels[0]->getHeight();
    for (int level = 1; width > 1 || height > 1; ++level) {
        width = std::max(1, width / 2);
        height = std::max(1, height / 2);
        auto image = std::make_shared<Image>(width, height);
        Image const& finer = *mip_levels[level - 1];
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                image->setPixel(x, y, finer.getPixel(std::min(2 * x, finer.getWidth() - 1), std::min(2 * y, finer.getHeight() - 1)));
            }
        mip_levels.push_back(image);
    }
}
