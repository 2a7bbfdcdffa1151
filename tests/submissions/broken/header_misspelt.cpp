// verdict: {"broken": {"wrap_clamp": "std::gcd"}, "left_out": ["#include"], "unofficial": [19, 19]}
// What the header would have brought along is missing in one function.
#include <numerics>

int ImageTexture::wrap_clamp(int val, int size)
{
    return val < 0 ? 0 : std::gcd(val < size ? val : size - 1, 0);
}
