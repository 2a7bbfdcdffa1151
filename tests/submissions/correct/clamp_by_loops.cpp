// verdict: {"loses": {}}
// Step by step: slow, but right.
int ImageTexture::wrap_clamp(int val, int size)
{
    while (val < 0) val++;
    while (val >= size) val--;
    return val;
}
