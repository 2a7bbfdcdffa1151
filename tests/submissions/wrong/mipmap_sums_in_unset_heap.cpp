// verdict: {"loses": {"create_mipmap": [1, 2]}, "says": {"create_mipmap": "partial"}, "policy": [], "remarks": ["differs_between_runs"], "sanitizers": false}
// Uninitialised read: adds up a row in new floats, which are not zero.
void ImageTexture::create_mipmap()
{
    mip_levels.resize(1);
    while (mip_levels.back()->getWidth() > 1 || mip_levels.back()->getHeight() > 1) {
        Image const& finer = *mip_levels.back();
        int const width = std::max(1, finer.getWidth() / 2);
        int const height = std::max(1, finer.getHeight() / 2);
        int const step_x = finer.getWidth() / width;
        int const step_y = finer.getHeight() / height;
        auto coarser = std::make_shared<Image>(width, height);
        for (int y = 0; y < height; ++y) {
            float* sums = new float[4 * width];
            for (int j = 0; j < step_y; ++j)
                for (int x = 0; x < finer.getWidth(); ++x)
                    for (int c = 0; c < 4; ++c)
                        sums[4 * (x / step_x) + c] += finer.getPixel(x, y * step_y + j)[c];
            for (int x = 0; x < width; ++x)
                coarser->setPixel(x, y, glm::vec4(sums[4 * x], sums[4 * x + 1], sums[4 * x + 2], sums[4 * x + 3]) /
                                            float(step_x * step_y));
            delete[] sums;
        }
        mip_levels.push_back(coarser);
    }
}
