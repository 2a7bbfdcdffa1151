#pragma once
#include <cstdint>
#include <random>
#include <string_view>

namespace testat {
/// A stream of numbers for one check, the same on every machine. It depends on the seed and the check's name only, so
/// a check asks the same questions whichever others run beside it.
class Random {
public:
    Random(std::uint64_t seed, std::string_view name) : engine_(seed * 0x9e3779b97f4a7c15u ^ hash(name)) {}

    /// Uniform in [lo, hi).
    double uniform(double lo, double hi) { return lo + (hi - lo) * (double(engine_() >> 11) * 0x1p-53); }
    /// Uniform in lo, ..., hi.
    int integer(int lo, int hi)
    {
        auto const range = std::uint64_t(std::int64_t(hi) - lo) + 1;
        return static_cast<int>(lo + std::int64_t(engine_() % range));
    }
    bool coin() { return (engine_() & 1) != 0; }

private:
    /// FNV-1a.
    static std::uint64_t hash(std::string_view name)
    {
        std::uint64_t h = 0xcbf29ce484222325u;
        for (char c : name)
            h = (h ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
        return h;
    }
    std::mt19937_64 engine_;
};
}  // namespace testat
