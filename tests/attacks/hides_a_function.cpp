// attack: {"at": "compile", "earns": [19, 19], "builds": false}
// Keeps one of the eleven to itself: it counts as missing.
#ifndef WITHOUT_ATTACK

#define HIDDEN [[gnu::visibility("hidden")]]
#else
#define HIDDEN
#endif

HIDDEN int ImageTexture::wrap_repeat(int val, int size)
{
    return (val % size + size) % size;
}
