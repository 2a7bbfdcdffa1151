// verdict: {"broken": {}, "left_out": [""], "unofficial": [20, 20]}
// Something to try it with that was not taken out again. Linkers name no line.
int main()
{
    return ImageTexture::wrap_repeat(-1, 8) == 7 ? 0 : 1;
}
