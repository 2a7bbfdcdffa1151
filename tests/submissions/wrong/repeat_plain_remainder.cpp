// verdict: {"loses": {"wrap_repeat": [0.5, 0.5]}, "says": {"wrap_repeat": "crashed"}, "policy": ["crashes"], "mistake": {"wrap_repeat": "repeat_plain_remainder"}}
// The remainder of a negative number is negative; get_texel asserts that the texel is inside.
int ImageTexture::wrap_repeat(int val, int size)
{
    return val % size;
}
