// attack: {"at": "load", "earns": [0, 0], "says": {"*": "timed_out"}}
// Never ends while it is loaded: stopped by its time limit, once for all.
#ifndef WITHOUT_ATTACK
[[gnu::constructor]] void loop()
{
    for (int volatile i = 0;; i = i + 1) {
    }
}
#endif
