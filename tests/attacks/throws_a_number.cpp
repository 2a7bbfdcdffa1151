// attack: {"at": "run", "earns": [19, 19], "says": {"wrap_repeat": "crashed"}, "policy": ["crashes"]}
// Throws something that is no exception through the probe: it has crashed.
int ImageTexture::wrap_repeat(int val, int size)
{
#ifndef WITHOUT_ATTACK
    throw 7;
#endif
    return (val % size + size) % size;
}
