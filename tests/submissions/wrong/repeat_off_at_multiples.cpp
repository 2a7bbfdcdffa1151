// verdict: {"loses": {"wrap_repeat": [0.5, 0.5]}, "says": {"wrap_repeat": "crashed"}, "policy": ["crashes"], "mistake": {"wrap_repeat": "repeat_off_at_multiples"}}
// Right but for negative multiples of size, which become size.
int ImageTexture::wrap_repeat(int val, int size)
{
    if (val < 0)
        return size - (-val % size);
    return val % size;
}
