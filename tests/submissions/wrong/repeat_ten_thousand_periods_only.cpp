// verdict: {"loses": {"wrap_repeat": [0.5, 0.5]}, "says": {"wrap_repeat": "partial"}, "policy": []}
// Adds a number of periods that seems large enough.
int ImageTexture::wrap_repeat(int val, int size)
{
    return (val + 10000 * size) % size;
}
