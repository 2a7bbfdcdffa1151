// verdict: {"loses": {"wrap_clamp": [0.5, 0.5]}, "says": {"wrap_clamp": "crashed"}, "policy": ["crashes"]}
// > where >= belongs: val = size stays.
int ImageTexture::wrap_clamp(int val, int size)

{
    if (val < 0) return 0;
    if (val > size) return size - 1;
    return val;
}
