// verdict: {"loses": {"wrap_clamp": [0.75, 0.75]}, "says": {"wrap_clamp": "partial"}, "policy": []}
// Below zero the last texel, beyond the end the first one.
int ImageTexture::wrap_clamp(int val, int size)

{
    if (val < 0)
        return size - 1;
    if (val > size - 1)
        return 0;
    return val;
}
