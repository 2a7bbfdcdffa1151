// verdict: {"broken": {}, "unofficial": null}
// No function of the sheet is to blame.
static int remainder_of(int val, int size)
{
    return val % sise;
}

int ImageTexture::wrap_repeat(int val, int size)
{
    return remainder_of(remainder_of(val, size) + size, size);
}
