// attack: {"at": "load", "earns": [20, 20]}
// Has numbers written with commas, and streams and terminate handlers of its own: nobody reads numbers as text.
#ifndef WITHOUT_ATTACK
#include <clocale>
#include <cstdlib>
#include <exception>
[[gnu::constructor]] void change()
{
    std::setlocale(LC_ALL, "de_DE.UTF-8");
    std::set_new_handler([] { std::_Exit(0); });
    std::set_terminate([] { std::_Exit(0); });
}
#endif
