#include "bench/filters.h"
#include "bench/filters/taps.h"

#include <algorithm>

namespace testat::bench {
namespace {
__m128 nearest(Mip const& mip, glm::vec2 const& uv)
{
    Floored const st(_mm_mul_ps(twice(uv), pairs(mip.size, mip.size)));
    int const x = _mm_cvtsi128_si32(st.whole) & mip.mask[0];
    int const y = _mm_cvtsi128_si32(_mm_shuffle_epi32(st.whole, 1)) & mip.mask[1];
    return texel(mip, x, y);
}

__m128 trilinear(Mips const& mips, glm::vec2 const& uv, int finer, float weight)
{
    Mip const& mip = mips.at(finer);
    if (!(weight > 0))
        return bilinear(mip, twice(uv));
    return bilinear_in_both(mip, mips.at(finer + 1), twice(uv), _mm_set1_ps(weight));
}

void trilinear(Mips const& mips, FourOf const& footprints, std::size_t count, glm::vec4* colours)
{
    Four const dudv([&](std::size_t i) { return &footprints[i].dudv.x; });
    __m128 const texels = _mm_max_ps(times(dudv.x, mips.size().x), times(dudv.y, mips.size().y));
    LevelsOfFour const levels(texels, mips.last());
    for (std::size_t i = 0; i < count; ++i)
        store(trilinear(mips, footprints[i].uv, levels.finer[i], levels.weight[i]), colours[i]);
}

/// `filter(mips, footprint)` for each footprint.
template <typename One>
LookUp one_by_one(TextureData const& texture, One const& filter)
{
    return [mips = Mips(texture), filter](Footprint const* footprints, std::size_t count, glm::vec4* colours) {
        for (std::size_t i = 0; i < count; ++i)
            store(filter(mips, footprints[i]), colours[i]);
    };
}
}  // namespace

LookUp prepare_fast_nearest(TextureData const& texture)
{
    return one_by_one(texture, [](Mips const& mips, Footprint const& f) { return nearest(mips.levels[0], f.uv); });
}

LookUp prepare_fast_bilinear(TextureData const& texture)
{
    return one_by_one(texture,
                      [](Mips const& mips, Footprint const& f) { return bilinear(mips.levels[0], twice(f.uv)); });
}

LookUp prepare_fast_trilinear(TextureData const& texture)
{
    return [mips = Mips(texture)](Footprint const* footprints, std::size_t count, glm::vec4* colours) {
        for (std::size_t i = 0; i < count; i += 4)
            trilinear(mips, FourOf(footprints + i, count - i), std::min<std::size_t>(4, count - i), colours + i);
    };
}
}  // namespace testat::bench
