// verdict: {"loses": {"create_mipmap": [1.5, 1.5]}, "says": {"create_mipmap": "partial"}, "policy": [], "mistake": {"create_mipmap": "mipmap_takes_one_texel"}}
// Every level samples level 0: one texel of each block instead of its average.
void ImageTexture::create_mipmap()
{
    int width = mip_levels[0]->getWidth();
    int height = mip_levels[0]->getHeight();
    while (width > 1 || height > 1) {
        width = std::max(1, width / 2);
        height = std::max(1, height / 2);
        auto coarser = std::make_shared<Image>(width, height);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                int const step = mip_levels[0]->getWidth() / width;
                int const step_v = mip_levels[0]->getHeight() / height;
                coarser->setPixel(x, y, mip_levels[0]->getPixel(x * step, y * step_v));
            }
        mip_levels.push_back(coarser);
    }
}
