// verdict: {"loses": {"wrap_repeat": [0.5, 0.5]}, "says": {"wrap_repeat": "partial"}, "policy": [], "mistake": {"wrap_repeat": "repeat_one_too_low"}}
// size - 1 + val % size: -1 becomes size - 2.
int ImageTexture::wrap_repeat(int val, int size)
{
    if (val < 0)
        return size - 1 + val % size;
    return val % size;
}
