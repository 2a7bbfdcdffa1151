// verdict: {"loses": {"create_mipmap": [1.5, 1.5]}, "says": {"create_mipmap": "partial"}, "policy": [], "mistake": {"create_mipmap": "mipmap_leaves_levels_empty"}}
// Allocates the levels and leaves them black.
void ImageTexture::create_mipmap()
{
    int width = mip_levels[0]->getWidth();
    int height = mip_levels[0]->getHeight();
    while (width > 1 || height > 1) {
        width = std::max(1, width / 2);
        height = std::max(1, height / 2);
        mip_levels.push_back(std::make_shared<Image>(width, height));
    }
}
