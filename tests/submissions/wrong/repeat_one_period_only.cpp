// verdict: {"loses": {"wrap_repeat": [1, 1]}, "says": {"wrap_repeat": "crashed"}, "policy": ["crashes"], "mistake": {"wrap_repeat": "repeat_one_period_only"}}
// Adds or subtracts size once.
int ImageTexture::wrap_repeat(int val, int size)
{
    if (val < 0)
        val += size;
    if (val >= size)
        val -= size;
    return val;
}
