// verdict: {"loses": {"wrap_repeat": [0.5, 0.5]}, "says": {"wrap_repeat": "crashed"}, "policy": ["crashes"]}
// Adds "enough" periods before the remainder: 100 are not enough far from the origin.
int ImageTexture::wrap_repeat(int val, int size)

{
    return (val + 100 * size) % size;
}
