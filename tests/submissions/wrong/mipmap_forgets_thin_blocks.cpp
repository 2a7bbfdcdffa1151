// verdict: {"loses": {"create_mipmap": [1, 1]}, "says": {"create_mipmap": "partial"}, "policy": [], "mistake": {"create_mipmap": "mipmap_divides_two_by_four"}}
// Where one side is 1 already, there are two texels in a block, but their sum is divided by four.
void ImageTexture::create_mipmap()

{
    while (mip_levels.back()->getWidth() > 1 || mip_levels.back()->getHeight() > 1) {
        const Image& prev = *mip_levels.back();
        int w = std::max(prev.getWidth() / 2, 1);
        int h = std::max(prev.getHeight() / 2, 1);
        auto next = std::make_shared<Image>(w, h);
        for (int y = 0; y < h; y++)
            for (int x = 0; x < w; x++) {
                glm::vec4 sum(0.f);
                for (int j = 2 * y; j < std::min(2 * y + 2, prev.getHeight()); j++)
                    for (int i = 2 * x; i < std::min(2 * x + 2, prev.getWidth()); i++)
                        sum += prev.getPixel(i, j);
                next->setPixel(x, y, sum * 0.25f);
            }
        mip_levels.push_back(next);
    }
}
