// verdict: {"loses": {"wrap_repeat": [0.5, 0.5]}, "says": {"wrap_repeat": "timed_out"}, "policy": []}
// An endless loop, for negative values only: the remainder stays negative for ever.
int ImageTexture::wrap_repeat(int val, int size)
{
    volatile int result = val;
    while (result < 0 || result >= size)
        result = result % size;
    return result;
}
