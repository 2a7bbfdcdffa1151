// verdict: {"loses": {"wrap_clamp": [0.75, 0.75]}, "says": {"wrap_clamp": "crashed"}, "policy": ["crashes"], "mistake": {"wrap_clamp": "clamp_does_nothing"}}
// Hands val back.
int ImageTexture::wrap_clamp(int val, int size)

{
    (void)size;
    return val;
}
