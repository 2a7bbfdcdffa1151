// verdict: {"loses": {"wrap_clamp": [0.5, 0.5]}, "says": {"wrap_clamp": "crashed"}, "policy": ["crashes"], "mistake": {"wrap_clamp": "clamp_to_size"}}
// Clamps to size instead of size - 1; get_texel asserts that the texel is inside.
int ImageTexture::wrap_clamp(int val, int size)
{
    return std::min(std::max(val, 0), size);
}
