// verdict: {"loses": {"create_mipmap": [1, 1]}, "says": {"create_mipmap": "partial"}, "policy": []}
// Leaves out textures more than sixteen times as wide as high.
void ImageTexture::create_mipmap()
{
    mip_levels.resize(1);
    if (mip_levels[0]->getWidth() > 16 * mip_levels[0]->getHeight())
        return;
    while (mip_levels.back()->getWidth() > 1 || mip_levels.back()->getHeight() > 1) {
        Image const& fine = *mip_levels.back();
        int w = std::max(1, fine.getWidth() / 2);
        int h = std::max(1, fine.getHeight() / 2);
        int nx = fine.getWidth() / w;
        int ny = fine.getHeight() / h;
        auto coarse = std::make_shared<Image>(w, h);
        for (int y = 0; y < h; ++y)
            for (int x = 0; x < w; ++x) {
                glm::vec4 sum(0);
                for (int j = 0; j < ny; ++j)
                    for (int i = 0; i < nx; ++i)
                        sum += fine.getPixel(x * nx + i, y * ny + j);
                coarse->setPixel(x, y, sum / float(nx * ny));
            }
        mip_levels.push_back(coarse);
    }
}
