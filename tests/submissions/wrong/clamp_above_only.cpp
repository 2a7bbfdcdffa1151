// verdict: {"loses": {"wrap_clamp": [0.5, 0.5]}, "says": {"wrap_clamp": "crashed"}, "policy": ["crashes"], "mistake": {"wrap_clamp": "clamp_above_only"}}
// Forgets the lower end.
int ImageTexture::wrap_clamp(int val, int size)
{
    if (val >= size)
        return size - 1;
    return val;
}
