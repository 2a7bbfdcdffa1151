// verdict: {"loses": {"wrap_clamp": [0.5, 0.5]}, "says": {"wrap_clamp": "crashed"}, "policy": ["crashes"], "mistake": {"wrap_clamp": "clamp_below_only"}}
// Forgets the upper end.
int ImageTexture::wrap_clamp(int val, int size)

{
    if (val < 0)
        return 0;
    return val;
}
