// verdict: {"loses": {"wrap_clamp": [1, 1]}, "says": {"wrap_clamp": "wrong"}, "policy": []}
// Nothing is assigned inside the range: whatever the register held.
int ImageTexture::wrap_clamp(int val, int size)

{
    int result;
    if (val < 0)
        result = 0;
    else if (val >= size)
        result = size - 1;
    return result;
}
