// verdict: {"loses": {}}
// ((v % n) + n) % n, and std::clamp.
int ImageTexture::wrap_clamp(int val, int size)
{
    return std::clamp(val, 0, size - 1);
}

int ImageTexture::wrap_repeat(int val, int size)
{
    return ((val % size) + size) % size;
}
