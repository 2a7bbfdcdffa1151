// verdict: {"loses": {}}
// One call for each period.
int ImageTexture::wrap_repeat(int val, int size)
{
    if (val < 0) return ImageTexture::wrap_repeat(val + size, size);
    if (val >= size) return ImageTexture::wrap_repeat(val - size, size);
    return val;
}
