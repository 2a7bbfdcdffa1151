// verdict: {"broken": {"wrap_repeat": "return remainder_of"}, "left_out": ["return val % sise;"], "unofficial": [19, 19]}
// No function of the sheet is to blame but those that use the helper.
static int remainder_of(int val, int size)
{
    return val % sise;
}

int ImageTexture::wrap_repeat(int val, int size)
{
    return remainder_of(remainder_of(val, size) + size, size);
}
