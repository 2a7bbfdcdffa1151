// verdict: {"loses": {"wrap_repeat": [0.5, 0.5]}, "says": {"wrap_repeat": "partial"}, "policy": [], "mistake": {"wrap_repeat": "repeat_abs"}}
// abs(val % size): mirrored below zero.
int ImageTexture::wrap_repeat(int val, int size)
{
    return std::abs(val % size);
}
