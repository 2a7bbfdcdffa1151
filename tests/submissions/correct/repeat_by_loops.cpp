// verdict: {"loses": {}}
// Slow while loops.
int ImageTexture::wrap_repeat(int val, int size)
{
    while (val < 0)
        val += size;
    while (val >= size)
        val -= size;
    return val;
}
