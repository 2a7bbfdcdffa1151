// verdict: {"loses": {"wrap_clamp": [0.5, 0.5]}, "says": {"wrap_clamp": "partial"}, "policy": [], "mistake": {"wrap_clamp": "clamp_to_zero"}}
// 0 for everything outside, as the mode ZERO sounds.
int ImageTexture::wrap_clamp(int val, int size)

{
    return (val < 0 || val >= size) ? 0 : val;
}
