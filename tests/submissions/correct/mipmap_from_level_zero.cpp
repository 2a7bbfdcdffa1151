// verdict: {"loses": {}}
// Each level as the mean of blocks of level 0.
void ImageTexture::create_mipmap()
{
    const int W = mip_levels[0]->getWidth(), H = mip_levels[0]->getHeight();
    for (int l = 1; (std::max(W, H) >> l) > 0; ++l) {
        int w = std::max(W >> l, 1), h = std::max(H >> l, 1), bx = W / w, by = H / h;
        mip_levels.emplace_back(std::make_shared<Image>(w, h));
        for (int y = 0; y < h; ++y) for (int x = 0; x < w; ++x) {
            glm::vec4 s(0.f);
            for (int j = 0; j < by; ++j) for (int i = 0; i < bx; ++i) s += mip_levels[0]->getPixel(x * bx + i, y * by + j);
            set_texel(l, x, y, s / (float)(bx * by));
        }
    }
}
