// attack: {"at": "run", "earns": [19.5, 20], "says": {"*": "any"}}
// Rounds downwards once it has been called: that spoils pictures of its own at most.
#ifndef WITHOUT_ATTACK
#include <cfenv>
#endif

int ImageTexture::wrap_repeat(int val, int size)
{
#ifndef WITHOUT_ATTACK
    std::fesetround(FE_DOWNWARD);
#endif
    return (val % size + size) % size;
}
