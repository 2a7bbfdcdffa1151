// verdict: {"loses": {}}
// A texture of one texel ends with two levels of one texel.
void ImageTexture::create_mipmap()
{
    int w = mip_levels[0]->getWidth();
    int h = mip_levels[0]->getHeight();
    do {
        Image const& fine = *mip_levels.back();
        w = std::max(1, w / 2);
        h = std::max(1, h / 2);
        auto coarse = std::make_shared<Image>(w, h);
        for (int y = 0; y < h; ++y)
            for (int x = 0; x < w; ++x) {
                int x0 = std::min(2 * x, fine.getWidth() - 1), x1 = std::min(2 * x + 1, fine.getWidth() - 1);
                int y0 = std::min(2 * y, fine.getHeight() - 1), y1 = std::min(2 * y + 1, fine.getHeight() - 1);
                coarse->setPixel(x, y, (fine.getPixel(x0, y0) + fine.getPixel(x1, y0) + fine.getPixel(x0, y1) +
                                        fine.getPixel(x1, y1)) * 0.25f);
            }
        mip_levels.push_back(coarse);
    } while (w > 1 || h > 1);
}
