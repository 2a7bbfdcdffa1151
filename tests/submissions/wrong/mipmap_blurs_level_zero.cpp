// verdict: {"loses": {"create_mipmap": [1.5, 1.5]}, "says": {"create_mipmap": "partial"}, "policy": []}
// Writes the averages back to the finer level, too: level 0 does not stay what it was.
void ImageTexture::create_mipmap()
{
    int width = mip_levels[0]->getWidth();
    int height = mip_levels[0]->getHeight();
    for (int level = 1; width > 1 || height > 1; ++level) {
        width = std::max(1, width / 2);
        height = std::max(1, height / 2);
        auto image = std::make_shared<Image>(width, height);
        Image& finer = *mip_levels[level - 1];
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                int const x1 = std::min(2 * x + 1, finer.getWidth() - 1);
                int const y1 = std::min(2 * y + 1, finer.getHeight() - 1);
                int const x0 = std::min(2 * x, finer.getWidth() - 1);
                int const y0 = std::min(2 * y, finer.getHeight() - 1);
                glm::vec4 const mean =
                    (finer.getPixel(x0, y0) + finer.getPixel(x1, y0) + finer.getPixel(x0, y1) + finer.getPixel(x1, y1)) / 4.f;
                finer.setPixel(x0, y0, mean);
                image->setPixel(x, y, mean);
            }
        mip_levels.push_back(image);
    }
}
