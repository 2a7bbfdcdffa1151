#include "bench/filters.h"
#include "bench/filters/taps.h"

#include <algorithm>

namespace testat::bench {
namespace {
/// Half as wide.
TextureData::Level narrowed(TextureData::Level const& wide)
{
    TextureData::Level level{wide.width / 2, wide.height, {}};
    level.texels.resize(wide.texels.size() / 2);
    for (std::size_t i = 0; i < level.texels.size() / 4; ++i)
        for (std::size_t c = 0; c < 4; ++c)
            level.texels[4 * i + c] = (wide.texels[8 * i + c] + wide.texels[8 * i + 4 + c]) / 2;
    return level;
}

/// Half as high.
TextureData::Level lowered(TextureData::Level const& high)
{
    TextureData::Level level{high.width, high.height / 2, {}};
    std::size_t const row = 4 * std::size_t(high.width);
    level.texels.resize(high.texels.size() / 2);
    for (std::size_t i = 0; i < level.texels.size(); ++i) {
        std::size_t const at = i / row * 2 * row + i % row;
        level.texels[i] = (high.texels[at] + high.texels[at + row]) / 2;
    }
    return level;
}

/// Level (x, y), halved x times along u and y times along v, is number y * (last + 1) + x.
std::shared_ptr<TextureData> make_levels(TextureData const& texture)
{
    auto all = std::make_shared<TextureData>();
    std::size_t const steps = texture.levels.size();
    for (std::size_t y = 0; y < steps; ++y) {
        all->levels.push_back(y == 0 ? texture.levels[0] : lowered(all->levels[(y - 1) * steps]));
        for (std::size_t x = 1; x < steps; ++x)
            all->levels.push_back(narrowed(all->levels.back()));
    }
    return all;
}

class Ripmap {
public:
    explicit Ripmap(TextureData const& texture)
        : last_(static_cast<int>(texture.levels.size()) - 1), mips_(make_levels(texture))
    {
    }

    void look_up(FourOf const& footprints, std::size_t count, glm::vec4* colours) const
    {
        Four const dudv([&](std::size_t i) { return &footprints[i].dudv.x; });
        LevelsOfFour const x(times(dudv.x, mips_.size().x), last_);
        LevelsOfFour const y(times(dudv.y, mips_.size().y), last_);
        for (std::size_t i = 0; i < count; ++i) {
            __m128 const uv = twice(footprints[i].uv);
            __m128 const colour = along_u(uv, x.finer[i], x.weight[i], y.finer[i]);
            if (!(y.weight[i] > 0))
                store(colour, colours[i]);
            else
                store(mix(colour, along_u(uv, x.finer[i], x.weight[i], y.finer[i] + 1), _mm_set1_ps(y.weight[i])),
                      colours[i]);
        }
    }

private:
    __m128 along_u(__m128 uv, int x, float weight, int y) const
    {
        if (!(weight > 0))
            return bilinear(at(x, y), uv);
        return bilinear_in_both(at(x, y), at(x + 1, y), uv, _mm_set1_ps(weight));
    }

    Mip const& at(int x, int y) const { return mips_.at(y * (last_ + 1) + x); }

    int last_;
    Mips mips_;
};
}  // namespace

LookUp prepare_ripmap(TextureData const& texture)
{
    return [ripmap = Ripmap(texture)](Footprint const* footprints, std::size_t count, glm::vec4* colours) {
        for (std::size_t i = 0; i < count; i += 4)
            ripmap.look_up(FourOf(footprints + i, count - i), std::min<std::size_t>(4, count - i), colours + i);
    };
}
}  // namespace testat::bench
