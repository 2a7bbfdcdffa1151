// verdict: {"broken": {}, "left_out": ["int x int y;"], "unofficial": [20, 20]}
// A struct that nothing uses.
struct Texel {
    int x int y;
};

int ImageTexture::wrap_clamp(int val, int size)
{
    return std::min(std::max(val, 0), size - 1);
}
