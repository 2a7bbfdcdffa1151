// verdict: {"loses": {"create_mipmap": [2, 2]}, "says": {"create_mipmap": "wrong"}, "policy": [], "mistake": {"create_mipmap": "mipmap_forgets_last_level"}}
// Ends with 2 x 2.
void ImageTexture::create_mipmap()
{
    int width = mip_levels[0]->getWidth();
    int height = mip_levels[0]->getHeight();
    while (width > 2 || height > 2) {
        std::shared_ptr<Image> finer = mip_levels.back();
        width = std::max(1, width / 2);
        height = std::max(1, height / 2);
        int const step_x = finer->getWidth() / width;
        int const step_y = finer->getHeight() / height;
        auto coarser = std::make_shared<Image>(width, height);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                glm::vec4 sum(0.f);
                for (int j = 0; j < step_y; ++j)
                    for (int i = 0; i < step_x; ++i)
                        sum += finer->getPixel(x * step_x + i, y * step_y + j);
                coarser->setPixel(x, y, sum / float(step_x * step_y));
            }
        mip_levels.push_back(coarser);
    }
}
