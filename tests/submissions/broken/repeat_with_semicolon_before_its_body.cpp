// verdict: {"broken": {"wrap_repeat": "int ImageTexture::wrap_repeat(int val, int size);"}, "unofficial": [19, 19]}
// The declaration ends before the body begins.
int ImageTexture::wrap_repeat(int val, int size);
{
    int const remainder = val % size;
    return remainder < 0 ? remainder + size : remainder;
}
