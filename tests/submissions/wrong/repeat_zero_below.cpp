// verdict: {"loses": {"wrap_repeat": [0.5, 0.5]}, "says": {"wrap_repeat": "partial"}, "policy": []}
// Repeats upward, but clamps below zero.
int ImageTexture::wrap_repeat(int val, int size)

{
    if (val < 0)
        return 0;
    return val % size;
}
