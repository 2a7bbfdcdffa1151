// verdict: {"loses": {"wrap_repeat": [1, 1]}, "says": {"wrap_repeat": "wrong"}, "policy": []}
// The fraction of val / size in float, times size: falls below the whole number where it rounds.
int ImageTexture::wrap_repeat(int val, int size)

{
    float const periods = float(val) / float(size);
    return int((periods - std::floor(periods)) * float(size));
}
