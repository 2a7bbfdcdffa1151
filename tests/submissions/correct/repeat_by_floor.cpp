// verdict: {"loses": {}}
// By the floor of a quotient in double, and a clamp by branches.
int ImageTexture::wrap_clamp(int val, int size)
{
    if (val < 0) return 0;
    if (val >= size) return size - 1;
    return val;
}

int ImageTexture::wrap_repeat(int val, int size)
{
    return val - size * int(std::floor(double(val) / size));
}
