// verdict: {"loses": {"wrap_repeat": [1, 1]}, "says": {"wrap_repeat": "crashed"}, "policy": ["crashes"]}
// Remainder by the last index, and a division by zero where there is one texel only.
int ImageTexture::wrap_repeat(int val, int size)

{
    int last = size - 1;
    int r = val % last;
    return r < 0 ? r + last : r;
}
