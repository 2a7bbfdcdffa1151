// attack: {"at": "run", "earns": [19, 19], "says": {"wrap_repeat": "crashed"}, "policy": ["crashes"]}
// Calls itself without end, each time with a large frame: it runs out of stack, and crashes.
int ImageTexture::wrap_repeat(int val, int size)
{
#ifndef WITHOUT_ATTACK
    char volatile frame[4096];
    frame[0] = char(val);
    return wrap_repeat(val + 1, size) + frame[0];
#endif
    return (val % size + size) % size;
}
