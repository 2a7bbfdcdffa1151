#include "bench/filters.h"
#include "bench/filters/ellipse.h"
#include "bench/filters/taps.h"

#include <algorithm>

// A grid of probes over the footprint, in cells that are as square as their number allows: for 4 probes a row along the
// longer axis where it is twice as long as the other one, or else 2 x 2 (rows are those of McCormack et al., "Feline",
// 1999). A probe is bilinear, so that it averages texels of side p (variance p^2 / 12 along each axis) by a tent as
// wide as two of them (p^2 / 6). It does as much as its cell of width w, w^2 / 12, if p = w / sqrt(3) = 0.58 w; then n
// probes in a row have the variance of the whole row, (n w)^2 / 12, too. Levels are whole here, though, up to sqrt(2)
// off, and texels that are too small alias where those that are too large only blur: p = 0.8 w errs least, measured on
// checkers.
namespace testat::bench {
namespace {
constexpr float texel_of_width = 0.8f;
constexpr float root_of_two = 1.41421356f;

/// The level with texels nearest to so many texels of level 0, by their ratio. Only the exponent is needed.
int nearest_level(float texels, int last)
{
    float const x = texels * root_of_two;
    std::uint32_t bits;
    std::memcpy(&bits, &x, sizeof bits);
    constexpr int bias = 127;
    return std::clamp(static_cast<int>(bits >> 23) - bias, 0, last);
}

class Anisotropic {
public:
    /// A power of four.
    Anisotropic(TextureData const& texture, int probes) : mips_(texture), size_(mips_.size()), probes_(probes) {}

    glm::vec2 size() const { return size_; }

    __m128 look_up(glm::vec2 const& uv, glm::vec2 direction, float major, float minor) const
    {
        if (!(major > 1.f))
            return bilinear(mips_.at(0), twice(uv));
        int along = probes_;
        int across = 1;
        for (; across < along && major * float(across) * 2 < minor * float(along); across *= 2)
            along /= 2;
        glm::vec2 const step = direction * (major / float(along));
        glm::vec2 const side = glm::vec2(-direction.y, direction.x) * (minor / float(across));
        float const cell = std::max(minor / float(across), major / float(along));
        return grid(mips_.at(nearest_level(cell * texel_of_width, mips_.last())), uv, step / size_, along, side / size_,
                    across);
    }

private:
    /// Two at a time.
    __m128 grid(Mip const& mip, glm::vec2 middle, glm::vec2 step, int along, glm::vec2 side, int across) const
    {
        glm::vec2 first = middle - step * (float(along - 1) / 2) - side * (float(across - 1) / 2);
        __m128 const steps = twice(step * 2.f);
        __m128 sum = _mm_setzero_ps();
        for (int j = 0; j < across; ++j, first += side) {
            glm::vec2 const second = first + step;
            __m128 uvs = pairs(&first.x, &second.x);
            for (int i = 0; i < along; i += 2) {
                sum = _mm_add_ps(sum, sum_of_two(mip, uvs));
                uvs = _mm_add_ps(uvs, steps);
            }
        }
        return _mm_mul_ps(sum, _mm_set1_ps(1.f / float(probes_)));
    }

    Mips mips_;
    glm::vec2 size_;
    int probes_;
};
/// The same for four probes, which are two pairs (a, b) and (-a, -b) around the middle, found for four footprints at
/// once.
class FourProbes {
public:
    explicit FourProbes(TextureData const& texture) : mips_(texture), size_(mips_.size()) {}

    void look_up(FourOf const& footprints, std::size_t count, glm::vec4* colours) const
    {
        EllipsesOfFour const ellipses(footprints, size_);
        __m128 const is_row = _mm_cmpgt_ps(ellipses.major, times(ellipses.minor, 2));
        __m128 offsets[4];
        find_offsets(ellipses, is_row, offsets);
        alignas(16) std::int32_t levels[4];
        _mm_store_si128(reinterpret_cast<__m128i*>(levels), find_levels(ellipses, is_row));
        int const magnified = _mm_movemask_ps(_mm_cmple_ps(ellipses.major, _mm_set1_ps(1)));
        for (std::size_t i = 0; i < count; ++i) {
            __m128 const uv = twice(footprints[i].uv);
            bool const one = (magnified >> i & 1) != 0;
            store(one ? bilinear(mips_.at(0), uv) : four(mips_.at(levels[i]), uv, offsets[i]), colours[i]);
        }
    }

private:
    static __m128 four(Mip const& mip, __m128 uv, __m128 offset)
    {
        __m128 const sum = _mm_add_ps(sum_of_two(mip, _mm_sub_ps(uv, offset)), sum_of_two(mip, _mm_add_ps(uv, offset)));
        return times(sum, 0.25f);
    }

    /// (a, b) of each footprint in uv space: 3/8 and 1/8 of the length in a row, or a quarter along and across.
    void find_offsets(EllipsesOfFour const& e, __m128 is_row, __m128 (&offsets)[4]) const
    {
        __m128 const quarter = times(e.major, 0.25f);
        __m128 const across = _mm_andnot_ps(is_row, times(e.minor, 0.25f));
        __m128 const a = EllipsesOfFour::chosen(is_row, times(e.major, 0.375f), quarter);
        __m128 const b = EllipsesOfFour::chosen(is_row, times(e.major, 0.125f), times(quarter, -1));
        __m128 const side_x = times(_mm_mul_ps(across, e.y), -1);
        __m128 const side_y = _mm_mul_ps(across, e.x);
        float const u = 1.f / size_.x;
        float const v = 1.f / size_.y;
        offsets[0] = times(_mm_add_ps(_mm_mul_ps(a, e.x), side_x), u);
        offsets[1] = times(_mm_add_ps(_mm_mul_ps(a, e.y), side_y), v);
        offsets[2] = times(_mm_add_ps(_mm_mul_ps(b, e.x), side_x), u);
        offsets[3] = times(_mm_add_ps(_mm_mul_ps(b, e.y), side_y), v);
        _MM_TRANSPOSE4_PS(offsets[0], offsets[1], offsets[2], offsets[3]);
    }

    /// As nearest_level does.
    __m128i find_levels(EllipsesOfFour const& e, __m128 is_row) const
    {
        __m128 const cell =
            EllipsesOfFour::chosen(is_row, _mm_max_ps(e.minor, times(e.major, 0.25f)), times(e.major, 0.5f));
        __m128 const texels = _mm_min_ps(_mm_max_ps(times(cell, texel_of_width * root_of_two), _mm_set1_ps(1)),
                                         _mm_set1_ps(std::max(size_.x, size_.y)));
        constexpr int bias = 127;
        return _mm_sub_epi32(_mm_srli_epi32(_mm_castps_si128(texels), 23), _mm_set1_epi32(bias));
    }

    Mips mips_;
    glm::vec2 size_;
};
}  // namespace

LookUp prepare_anisotropic(TextureData const& texture, int probes)
{
    if (probes != 4)
        return by_ellipses(Anisotropic(texture, probes));
    return [filter = FourProbes(texture)](Footprint const* footprints, std::size_t count, glm::vec4* colours) {
        for (std::size_t i = 0; i < count; i += 4)
            filter.look_up(FourOf(footprints + i, count - i), std::min<std::size_t>(4, count - i), colours + i);
    };
}
}  // namespace testat::bench
