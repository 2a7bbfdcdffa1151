// attack: {"at": "compile", "earns": [0, 0], "builds": false}
// Instantiates two more templates for each: the compiler is stopped by its time limit.
#ifndef WITHOUT_ATTACK
template <int depth, long place>
struct Node {
    static constexpr int value = Node<depth - 1, 2 * place>::value + Node<depth - 1, 2 * place + 1>::value;
};
template <long place>
struct Node<0, place> {
    static constexpr int value = 1;
};
int const leaves = Node<60, 0>::value;
#endif
