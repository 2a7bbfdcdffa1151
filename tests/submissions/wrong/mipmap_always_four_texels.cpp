// verdict: {"loses": {"create_mipmap": [0.25, 1]}, "says": {"create_mipmap": "partial"}, "policy": [], "mistake": {"create_mipmap": "mipmap_divides_two_by_four"}}
// Where a side is 1, get_texel gives the second texel: the first one again, or black if the wrap mode says so.
void ImageTexture::create_mipmap()
{
    int w = mip_levels[0]->getWidth(), h = mip_levels[0]->getHeight();
    for (int level = 1; w > 1 || h > 1; ++level) {
        w = std::max(w / 2, 1);
        h = std::max(h / 2, 1);
        mip_levels.push_back(std::make_shared<Image>(w, h));
        for (int y = 0; y < h; y++)
            for (int x = 0; x < w; x++)
                set_texel(level, x, y,
                          (get_texel(level - 1, 2 * x, 2 * y) + get_texel(level - 1, 2 * x + 1, 2 * y) +
                           get_texel(level - 1, 2 * x, 2 * y + 1) + get_texel(level - 1, 2 * x + 1, 2 * y + 1)) / 4.f);
    }
}
