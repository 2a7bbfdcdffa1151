// verdict: {"broken": {"wrap_clamp": "return limit(std::min", "wrap_repeat": "return limit(remainder"}, "left_out": ["return std::maxx"], "unofficial": [18, 18]}
// The helper is misspelt, and two functions use it; one without it is not touched.
namespace {
int unused_and_right()
{
    return 1;
}

int limit(int val)
{
    return std::maxx(val, 0);
}
}  // namespace

int ImageTexture::wrap_clamp(int val, int size)
{
    return limit(std::min(val, size - 1));
}

int ImageTexture::wrap_repeat(int val, int size)
{
    int const remainder = val % size;
    return limit(remainder < 0 ? remainder + size : remainder);
}
