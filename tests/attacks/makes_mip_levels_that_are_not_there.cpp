// attack: {"at": "run", "earns": [18, 18], "says": {"create_mipmap": "crashed"}, "policy": ["crashes"]}
// Makes levels that are null: it crashes.
void ImageTexture::create_mipmap()
{
#ifndef WITHOUT_ATTACK
    mip_levels.resize(100);
#endif
}
