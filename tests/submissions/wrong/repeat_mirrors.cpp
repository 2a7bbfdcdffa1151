// verdict: {"loses": {"wrap_repeat": [1, 1]}, "says": {"wrap_repeat": "wrong"}, "policy": [], "mistake": {"wrap_repeat": "repeat_mirrors"}}
// Runs back and forth: MIRRORED_REPEAT instead of REPEAT.
int ImageTexture::wrap_repeat(int val, int size)

{
    int const period = 2 * size;
    int const place = ((val % period) + period) % period;
    return place < size ? place : period - 1 - place;
}
