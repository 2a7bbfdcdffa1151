// verdict: {"loses": {"create_mipmap": [1, 1]}, "says": {"create_mipmap": "crashed"}, "policy": []}
// Width where height belongs: every level is square.
void ImageTexture::create_mipmap()
{
    int width = mip_levels[0]->getWidth();
    int height = mip_levels[0]->getHeight();
    for (int level = 1; width > 1; ++level) {
        width = std::max(1, width / 2);
        height = width;
        auto image = std::make_shared<Image>(width, height);
        Image const& finer = *mip_levels[level - 1];
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                glm::vec4 sum(0.f);
                for (int j = 0; j < 2; ++j)
                    for (int i = 0; i < 2; ++i)
                        sum += finer.getPixel(2 * x + i, 2 * y + j);
                image->setPixel(x, y, sum / 4.f);
            }
        mip_levels.push_back(image);
    }
}
