// verdict: {"loses": {}}
// Halfway between texel centres, a bilinear lookup is the mean.
void ImageTexture::create_mipmap()
{
    int w = mip_levels[0]->getWidth(), h = mip_levels[0]->getHeight(), l = 0;
    while (w != 1 || h != 1) {
        w = std::max(w / 2, 1); h = std::max(h / 2, 1);
        std::shared_ptr<Image> im = std::make_shared<Image>(w, h);
        for (int x = 0; x < w; ++x) for (int y = 0; y < h; ++y)
            im->setPixel(x, y, evaluate_bilinear(l, glm::vec2((x + 0.5f) / w, (y + 0.5f) / h)));
        mip_levels.push_back(im); ++l;
    }
}
