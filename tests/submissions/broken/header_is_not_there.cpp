// verdict: {"broken": {}, "unofficial": null}
// Nobody knows what it would have brought along.
#include "my_vectors.h"

int ImageTexture::wrap_clamp(int val, int size)
{
    return val < 0 ? 0 : val < size ? val : size - 1;
}
