// verdict: {"loses": {"wrap_clamp": [0.75, 0.75]}, "says": {"wrap_clamp": "partial"}, "policy": [], "mistake": {"wrap_clamp": "clamp_repeats"}}
// Repeats. Written for the next function, and copied.
int ImageTexture::wrap_clamp(int val, int size)

{
    val %= size;
    if (val < 0)
        val += size;
    return val;
}
