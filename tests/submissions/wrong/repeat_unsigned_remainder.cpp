// verdict: {"loses": {"wrap_repeat": [0.5, 0.5]}, "says": {"wrap_repeat": "partial"}, "policy": []}
// The remainder of an unsigned number: below zero right for powers of two only.
int ImageTexture::wrap_repeat(int val, int size)

{
    return (unsigned int)val % (unsigned int)size;
}
