// attack: {"at": "compile", "earns": [0, 0], "builds": false}
// Computes for ever while compiling: the compiler gives up, or is stopped by its time limit.
#ifndef WITHOUT_ATTACK
constexpr long turns(long n)
{
    long sum = 0;
    for (long i = 0; i < n; ++i)
        for (long j = 0; j < n; ++j)
            sum += i ^ j;
    return sum;
}
template <long n>
struct Turns {
    static constexpr long value = turns(4000 + n) + Turns<n - 1>::value;
};
template <>
struct Turns<0> {
    static constexpr long value = 0;
};
constexpr long turned = Turns<200>::value;
#endif
