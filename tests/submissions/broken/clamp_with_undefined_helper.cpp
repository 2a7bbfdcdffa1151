// verdict: {"broken": {"wrap_clamp": "int ImageTexture::wrap_clamp(int val, int size)"}, "unofficial": [19, 19]}
// The helper is declared, and defined nowhere: only the linker says so.
int nearest_index(int val, int size);

int ImageTexture::wrap_clamp(int val, int size)
{
    return nearest_index(val, size);
}
