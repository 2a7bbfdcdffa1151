// verdict: {"loses": {}}
// A recursive helper that returns the rest of the chain.
static void append(std::vector<std::shared_ptr<Image>>& levels)
{
    std::shared_ptr<Image> fine = levels.back();
    int w = fine->getWidth(), h = fine->getHeight();
    if (w == 1 && h == 1)
        return;
    auto coarse = std::make_shared<Image>(w > 1 ? w / 2 : 1, h > 1 ? h / 2 : 1);
    for (int i = 0; i < coarse->getWidth(); i++)
        for (int j = 0; j < coarse->getHeight(); j++) {
            int i1 = w > 1 ? 2 * i + 1 : 0, j1 = h > 1 ? 2 * j + 1 : 0;
            coarse->setPixel(i, j, (fine->getPixel(2 * i, 2 * j) + fine->getPixel(i1, 2 * j) + fine->getPixel(2 * i, j1) +
                                    fine->getPixel(i1, j1)) / 4.f);
        }
    levels.push_back(coarse);
    append(levels);
}

void ImageTexture::create_mipmap()
{
    append(mip_levels);
}
