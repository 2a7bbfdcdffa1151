// verdict: {"loses": {"create_mipmap": [1.5, 1.5]}, "says": {"create_mipmap": "partial"}, "policy": [], "mistake": {"create_mipmap": "mipmap_averages_two_texels"}}
// The average of two neighbours along x only.
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
                int const x1 = std::min(2 * x + 1, finer.getWidth() - 1);
                image->setPixel(x, y, 0.5f * (finer.getPixel(2 * x, std::min(2 * y, finer.getHeight() - 1)) + finer.getPixel(x1, std::min(2 * y, finer.getHeight() - 1))));
            }
        mip_levels.push_back(image);
    }
}
