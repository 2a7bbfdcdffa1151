// verdict: {"loses": {"create_mipmap": [1, 1]}, "says": {"create_mipmap": "crashed"}, "policy": []}
// Always four texels: where a side is 1, the second one does not exist.
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
                glm::vec4 sum = finer.getPixel(2 * x, 2 * y) + finer.getPixel(2 * x + 1, 2 * y) +
                                finer.getPixel(2 * x, 2 * y + 1) + finer.getPixel(2 * x + 1, 2 * y + 1);
                image->setPixel(x, y, sum / 4.f);
            }
        mip_levels.push_back(image);
    }
}
