#pragma once
#include "bench/filters/taps.h"

namespace testat::bench {
/// Of four footprints, each the ellipse with its second moments: a parallelogram with edges a and b has the covariance
/// (a a^T + b b^T) / 12, and so has a rectangle along the ellipse's axes.
class EllipsesOfFour {
public:
    /// `size`: of level 0, in texels.
    EllipsesOfFour(FourOf const& footprints, glm::vec2 size)
    {
        Four a([&](std::size_t i) { return &footprints[i].dx.x; });
        Four b([&](std::size_t i) { return &footprints[i].dy.x; });
        scale(a, size);
        scale(b, size);
        __m128 const xx = _mm_add_ps(_mm_mul_ps(a.x, a.x), _mm_mul_ps(b.x, b.x));
        __m128 const yy = _mm_add_ps(_mm_mul_ps(a.y, a.y), _mm_mul_ps(b.y, b.y));
        __m128 const xy = _mm_add_ps(_mm_mul_ps(a.x, a.y), _mm_mul_ps(b.x, b.y));
        __m128 const half = times(_mm_sub_ps(xx, yy), 0.5f);
        __m128 const spread = _mm_sqrt_ps(_mm_add_ps(_mm_mul_ps(half, half), _mm_mul_ps(xy, xy)));
        // Also where there is no footprint at all, nothing is divided by zero.
        __m128 const tiny = _mm_set1_ps(1e-30f);
        __m128 const length = _mm_max_ps(_mm_sqrt_ps(_mm_add_ps(times(_mm_add_ps(xx, yy), 0.5f), spread)), tiny);
        // The determinant is the product of both axes; subtracting would leave nothing of the smaller one.
        __m128 const area = magnitude(_mm_sub_ps(_mm_mul_ps(a.x, b.y), _mm_mul_ps(a.y, b.x)));
        major = length;
        minor = _mm_div_ps(area, length);
        // (half + spread, xy) and (xy, spread - half) are parallel; the longer one is the better one.
        __m128 const wide = _mm_cmpgt_ps(half, _mm_setzero_ps());
        __m128 const longer = _mm_add_ps(magnitude(half), spread);
        __m128 const norm = _mm_max_ps(_mm_sqrt_ps(_mm_add_ps(_mm_mul_ps(longer, longer), _mm_mul_ps(xy, xy))), tiny);
        x = _mm_div_ps(chosen(wide, longer, xy), norm);
        y = _mm_div_ps(chosen(wide, xy, longer), norm);
    }
    __m128 major;  ///< length of the rectangle, in texels of level 0
    __m128 minor;  ///< its width
    __m128 x;      ///< along the major axis, unit; zero if there is no footprint
    __m128 y;

    static __m128 chosen(__m128 mask, __m128 yes, __m128 no)
    {
        return _mm_or_ps(_mm_and_ps(mask, yes), _mm_andnot_ps(mask, no));
    }

private:
    static void scale(Four& v, glm::vec2 size)
    {
        v.x = times(v.x, size.x);
        v.y = times(v.y, size.y);
    }
    static __m128 magnitude(__m128 v) { return _mm_andnot_ps(_mm_set1_ps(-0.f), v); }
};

/// A filter that needs the ellipse: `filter.look_up(uv, direction, major, minor)` for each footprint.
template <typename Filter>
auto by_ellipses(Filter filter)
{
    return [filter = std::move(filter)](Footprint const* footprints, std::size_t count, glm::vec4* colours) {
        for (std::size_t i = 0; i < count; i += 4) {
            FourOf const four(footprints + i, count - i);
            EllipsesOfFour const ellipses(four, filter.size());
            alignas(16) float major[4], minor[4], x[4], y[4];
            _mm_store_ps(major, ellipses.major);
            _mm_store_ps(minor, ellipses.minor);
            _mm_store_ps(x, ellipses.x);
            _mm_store_ps(y, ellipses.y);
            for (std::size_t j = 0; j < 4 && i + j < count; ++j)
                store(filter.look_up(four[j].uv, {x[j], y[j]}, major[j], minor[j]), colours[i + j]);
        }
    };
}
}  // namespace testat::bench
