// verdict: {"loses": {"wrap_repeat": [1, 1]}, "says": {"wrap_repeat": "wrong"}, "policy": [], "mistake": {"wrap_repeat": "repeat_clamps"}}
// The function before, once more.
int ImageTexture::wrap_repeat(int val, int size)

{
    return std::max(0, std::min(val, size - 1));
}
