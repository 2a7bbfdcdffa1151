// verdict: {"broken": {}, "left_out": ["notes to myself"], "unofficial": [20, 20]}
// A remark that is no comment.
notes to myself;

int ImageTexture::wrap_clamp(int val, int size)
{
    return std::min(std::max(val, 0), size - 1);
}
