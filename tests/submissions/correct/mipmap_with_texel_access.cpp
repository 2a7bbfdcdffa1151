// verdict: {"loses": {}}
// get_texel and set_texel, the second tap clamped: where a side is 1, it is taken twice.
void ImageTexture::create_mipmap()
{
    int w = mip_levels[0]->getWidth(), h = mip_levels[0]->getHeight();
    for (int level = 1; w > 1 || h > 1; ++level) {
        int fw = w, fh = h;
        w = std::max(w / 2, 1);
        h = std::max(h / 2, 1);
        mip_levels.push_back(std::shared_ptr<Image>(new Image(w, h)));
        for (int x = 0; x < w; x++)
            for (int y = 0; y < h; y++) {
                int x0 = 2 * x % fw, x1 = std::min(2 * x + 1, fw - 1);
                int y0 = 2 * y % fh, y1 = std::min(2 * y + 1, fh - 1);
                set_texel(level, x, y, 0.25f * (get_texel(level - 1, x0, y0) + get_texel(level - 1, x1, y0) +
                                                get_texel(level - 1, x0, y1) + get_texel(level - 1, x1, y1)));
            }
    }
}
