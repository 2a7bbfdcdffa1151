// verdict: {"loses": {}}
// Saved on Windows.
int ImageTexture::wrap_clamp(int val, int size)
{
    if (val < 0)
        return 0;
    return val >= size ? size - 1 : val;
}
