// verdict: {"broken": {}, "left_out": ["#include"], "unofficial": [20, 20]}
// A header of the student's own that was not handed in, and that nothing needs.
#include "my_vectors.h"

int ImageTexture::wrap_clamp(int val, int size)
{
    return val < 0 ? 0 : val < size ? val : size - 1;
}
