// verdict: {"loses": {}}
// One call for each step: slow, but right.
int ImageTexture::wrap_clamp(int val, int size)
{
    if (val < 0) return wrap_clamp(val + 1, size);
    if (val >= size) return wrap_clamp(val - 1, size);
    return val;
}
