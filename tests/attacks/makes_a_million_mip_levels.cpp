// attack: {"at": "run", "earns": [18, 18], "says": {"create_mipmap": "wrong"}}
// Makes levels without number, more than there is room for in an answer: too many, and wrong.
void ImageTexture::create_mipmap()
{
#ifndef WITHOUT_ATTACK
    while (mip_levels.size() < 1000000)
        mip_levels.push_back(mip_levels[0]);
#endif
}
