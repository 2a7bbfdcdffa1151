// verdict: {"loses": {}}
// First halves both sides, then the one that is left; divides at each step.
namespace
{
std::shared_ptr<Image> halve(Image const& fine, bool along_x, bool along_y)
{
    int dx = along_x ? 2 : 1, dy = along_y ? 2 : 1;
    std::shared_ptr<Image> coarse = std::make_shared<Image>(fine.getWidth() / dx, fine.getHeight() / dy);
    for (int y = 0; y < coarse->getHeight(); ++y)
        for (int x = 0; x < coarse->getWidth(); ++x) {
            glm::vec4 mean(0.f);
            for (int j = 0; j < dy; ++j)
                for (int i = 0; i < dx; ++i)
                    mean += fine.getPixel(dx * x + i, dy * y + j) / float(dx * dy);
            coarse->setPixel(x, y, mean);
        }
    return coarse;
}
}  // namespace

void ImageTexture::create_mipmap()
{
    while (mip_levels.back()->getWidth() > 1 && mip_levels.back()->getHeight() > 1)
        mip_levels.push_back(halve(*mip_levels.back(), true, true));
    while (mip_levels.back()->getWidth() > 1 || mip_levels.back()->getHeight() > 1)
        mip_levels.push_back(halve(*mip_levels.back(), mip_levels.back()->getWidth() > 1, mip_levels.back()->getHeight() > 1));
}
