// verdict: {"loses": {"create_mipmap": [1.5, 1.5]}, "says": {"create_mipmap": "partial"}, "policy": []}
// Averages 2 x 2 texels of level 0 for every level: right for level 1 only.
void ImageTexture::create_mipmap()
{
    int width = mip_levels[0]->getWidth();
    int height = mip_levels[0]->getHeight();
    for (int level = 1; width > 1 || height > 1; ++level) {
        width = std::max(1, width / 2);
        height = std::max(1, height / 2);
        auto image = std::make_shared<Image>(width, height);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                int const step_x = mip_levels[0]->getWidth() / width;
                int const step_y = mip_levels[0]->getHeight() / height;
                glm::vec4 sum(0.f);
                for (int j = 0; j < std::min(step_y, 2); ++j)
                    for (int i = 0; i < std::min(step_x, 2); ++i)
                        sum += mip_levels[0]->getPixel(x * step_x + i, y * step_y + j);
                image->setPixel(x, y, sum / float(std::min(step_x, 2) * std::min(step_y, 2)));
            }
        mip_levels.push_back(image);
    }
}
