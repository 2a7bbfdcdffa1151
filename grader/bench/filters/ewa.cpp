#include "bench/filters.h"
#include "bench/filters/ellipse.h"
#include "bench/filters/taps.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace testat::bench {
namespace {
/// Longer ellipses are made wider, as hardware and renderers do, so that a lookup has an end.
constexpr float most_anisotropic = 16;

/// Texels of the level used along the minor axis, at least: finer levels cost more, coarser ones alias.
constexpr float texels_across = 1.5f;

/// exp(-6 q) for q in [0, 1): the ellipse ends where it is 0.0025 of its middle. With the radius of the ellipse equal
/// to a side of the footprint, the variance along each axis is 1/12 of the side's square, that of the footprint.
constexpr float steepness = 6;

class Gaussian {
public:
    Gaussian()
    {
        for (std::size_t i = 0; i < size; ++i)
            values_[i] = std::exp(-steepness * (float(i) + 0.5f) / float(size));
    }
    float at(float q) const { return values_[static_cast<std::size_t>(q * float(size))]; }

private:
    static constexpr std::size_t size = 256;
    std::array<float, size> values_{};
};

/// A x^2 + B x y + C y^2 < 1 around a centre, in texels of a level.
struct Quadratic {
    float a, b, c;
    float reach_x, reach_y;  ///< half the sides of the box around it
};

/// Semi-axes are `major` and `minor` long.
Quadratic quadratic(glm::vec2 direction, float major, float minor)
{
    float const p = 1 / (major * major);
    float const q = 1 / (minor * minor);
    float const x = direction.x * direction.x;
    float const y = direction.y * direction.y;
    return {p * x + q * y, 2 * (p - q) * direction.x * direction.y, p * y + q * x,
            std::sqrt(major * major * x + minor * minor * y), std::sqrt(major * major * y + minor * minor * x)};
}

class Ewa {
public:
    explicit Ewa(TextureData const& texture) : mips_(texture), size_(mips_.size()) {}

    glm::vec2 size() const { return size_; }

    __m128 look_up(glm::vec2 const& uv, glm::vec2 direction, float major, float minor) const
    {
        if (!(major > 1.f))
            return bilinear(mips_.at(0), twice(uv));
        // Where a footprint is narrower than a texel there may be none in it: it is made wider.
        float const width = std::max({minor, major / most_anisotropic, 1.f});
        int const level = width > texels_across ? std::min(std::ilogb(width / texels_across), mips_.last()) : 0;
        return gather(level, uv, direction, std::max(major, width), width);
    }

private:
    /// Axes in texels of level 0.
    __m128 gather(int level, glm::vec2 const& uv, glm::vec2 direction, float major, float minor) const
    {
        Mip const& mip = mips_.at(level);
        float const scale = mip.size[0] / size_.x;
        Quadratic const q = quadratic(direction, scale * major, scale * minor);
        return sum(mip, uv.x * mip.size[0] - 0.5f, uv.y * mip.size[1] - 0.5f, q, twice(uv));
    }

    __m128 sum(Mip const& mip, float s, float t, Quadratic const& q, __m128 uv) const
    {
        int const first_x = static_cast<int>(std::ceil(s - q.reach_x));
        int const last_x = static_cast<int>(std::floor(s + q.reach_x));
        int const last_y = static_cast<int>(std::floor(t + q.reach_y));
        __m128 colour = _mm_setzero_ps();
        float weights = 0;
        for (int y = static_cast<int>(std::ceil(t - q.reach_y)); y <= last_y; ++y) {
            float const dy = float(y) - t;
            for (int x = first_x; x <= last_x; ++x) {
                float const dx = float(x) - s;
                float const r = (q.a * dx + q.b * dy) * dx + q.c * dy * dy;
                if (!(r < 1))
                    continue;
                float const weight = gaussian_.at(std::max(r, 0.f));
                weights += weight;
                colour =
                    _mm_add_ps(colour, _mm_mul_ps(texel(mip, x & mip.mask[0], y & mip.mask[1]), _mm_set1_ps(weight)));
            }
        }
        return weights > 0 ? _mm_div_ps(colour, _mm_set1_ps(weights)) : bilinear(mip, uv);
    }

    Mips mips_;
    glm::vec2 size_;
    Gaussian gaussian_;
};
}  // namespace

LookUp prepare_ewa(TextureData const& texture)
{
    return by_ellipses(Ewa(texture));
}
}  // namespace testat::bench
