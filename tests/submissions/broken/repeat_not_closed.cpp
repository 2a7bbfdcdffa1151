// verdict: {"broken": {"wrap_repeat": "int ImageTexture::wrap_repeat(int val, int size)"}, "unofficial": [19, 19]}
// The brace of the if is not closed, so that it swallows the functions behind it.
int ImageTexture::wrap_repeat(int val, int size)
{
    int const remainder = val % size;
    if (remainder < 0) {
        return remainder + size;
    return remainder;
}
