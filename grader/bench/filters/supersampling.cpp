#include "bench/filters.h"
#include "bench/filters/taps.h"

namespace testat::bench {
namespace {
/// An even number of lookups, two at a time.
__m128 mean_of_grid(Mip const& mip, Footprint const& f, int side)
{
    glm::vec2 const dx = f.dx / float(side);
    glm::vec2 const dy = f.dy / float(side);
    glm::vec2 const first = f.uv - (dx + dy) * (float(side - 1) / 2);
    __m128 sum = _mm_setzero_ps();
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; x += 2) {
            glm::vec2 const left = first + dx * float(x) + dy * float(y);
            glm::vec2 const right = left + dx;
            sum = _mm_add_ps(sum, sum_of_two(mip, pairs(&left.x, &right.x)));
        }
    return _mm_mul_ps(sum, _mm_set1_ps(1.f / float(side * side)));
}
}  // namespace

LookUp prepare_supersampling(TextureData const& texture, int side)
{
    return [mips = Mips(texture), side](Footprint const* footprints, std::size_t count, glm::vec4* colours) {
        for (std::size_t i = 0; i < count; ++i)
            store(mean_of_grid(mips.at(0), footprints[i], side), colours[i]);
    };
}
}  // namespace testat::bench
