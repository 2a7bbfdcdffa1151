// verdict: {"loses": {"create_mipmap": [2, 2]}, "says": {"create_mipmap": "wrong"}, "policy": []}
// A do-while loop with its test one step late: a second level of 1 x 1.
void ImageTexture::create_mipmap()

{
    int w = mip_levels[0]->getWidth();
    int h = mip_levels[0]->getHeight();
    bool last;
    do {
        last = w == 1 && h == 1;
        std::shared_ptr<Image> finer = mip_levels.back();
        int const step_x = w > 1 ? 2 : 1;
        int const step_y = h > 1 ? 2 : 1;
        w /= step_x;
        h /= step_y;
        auto coarser = std::make_shared<Image>(w, h);
        for (int y = 0; y < h; ++y)
            for (int x = 0; x < w; ++x) {
                glm::vec4 sum(0.f);
                for (int j = 0; j < step_y; ++j)
                    for (int i = 0; i < step_x; ++i)
                        sum += finer->getPixel(x * step_x + i, y * step_y + j);
                coarser->setPixel(x, y, sum / float(step_x * step_y));
            }
        mip_levels.push_back(coarser);
    } while (!last);
}
