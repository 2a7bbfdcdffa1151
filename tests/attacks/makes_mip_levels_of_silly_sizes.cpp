// attack: {"at": "run", "earns": [18, 18], "says": {"create_mipmap": "crashed"}, "policy": ["crashes"]}
// Makes a level that is larger than memory: it runs out of memory, and crashes.
void ImageTexture::create_mipmap()
{
#ifndef WITHOUT_ATTACK
    mip_levels.push_back(std::make_shared<Image>(1 << 15, 1 << 15));
#endif
}
