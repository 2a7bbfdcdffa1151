// verdict: {"broken": {"wrap_clamp": "return clamp_index(val", "create_mipmap": "int const width = finer.width()", "intersect": "return geo.intersect"}, "unofficial": [15, 15]}
// Three functions, each with an error of its own.
int ImageTexture::wrap_clamp(int val, int size)
{
    return clamp_index(val, 0, size - 1);
}

void ImageTexture::create_mipmap()
{
    Image const& finer = *mip_levels.back();
    int const width = finer.width() / 2;
    mip_levels.push_back(std::make_shared<Image>(width, width));
}

bool Object::intersect(Ray const& ray, Intersection* isect) const
{
    return geo.intersect(ray, isect);
}
