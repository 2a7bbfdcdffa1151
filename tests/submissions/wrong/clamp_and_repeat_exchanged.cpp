// verdict: {"loses": {"wrap_clamp": [0.75, 0.75], "wrap_repeat": [1, 1]}, "says": {"wrap_clamp": "partial", "wrap_repeat": "wrong"}, "policy": [], "mistake": {"wrap_clamp": "clamp_repeats", "wrap_repeat": "repeat_clamps"}}
// The two wrap functions exchanged.
int ImageTexture::wrap_clamp(int val, int size)
{
    return ((val % size) + size) % size;
}

int ImageTexture::wrap_repeat(int val, int size)
{
    return val < 0 ? 0 : val >= size ? size - 1 : val;
}
