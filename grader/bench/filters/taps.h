#pragma once
#include "bench/footprint.h"
#include "protocol/request.h"

#include <emmintrin.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <memory>
#include <vector>

/// Texels, four channels at a time. SSE2 only, which every x86-64 has: no filter has flags of its own.
namespace testat::bench {
/// One level. Rows and columns of texels are looked up in bytes from the first texel.
struct Mip {
    explicit Mip(TextureData::Level const& level)
        : texels(level.texels.data()),
          size{float(level.width), float(level.height)},
          mask{level.width - 1, level.height - 1},
          row{0, static_cast<std::int16_t>(level.width)}
    {
    }
    float const* texels;
    float size[2];
    std::int32_t mask[2];  ///< of a repeated texel coordinate
    std::int16_t row[2];   ///< what x and y are multiplied with to find a row
};

/// A texture with its levels, as filters keep it.
struct Mips {
    explicit Mips(TextureData const& texture) : Mips(std::make_shared<TextureData>(texture)) {}
    explicit Mips(std::shared_ptr<TextureData const> texture) : data(std::move(texture))
    {
        for (auto const& level : data->levels)
            levels.emplace_back(level);
    }
    Mip const& at(int level) const { return levels[static_cast<std::size_t>(level)]; }
    int last() const { return static_cast<int>(levels.size()) - 1; }
    glm::vec2 size() const { return {levels[0].size[0], levels[0].size[1]}; }

    std::shared_ptr<TextureData const> data;  ///< owns the texels
    std::vector<Mip> levels;
};

inline __m128 texel(Mip const& mip, int x, int y)
{
    return _mm_loadu_ps(mip.texels + 4 * (std::ptrdiff_t(y) * (mip.mask[0] + 1) + x));
}

inline __m128 mix(__m128 a, __m128 b, __m128 t)
{
    return _mm_add_ps(a, _mm_mul_ps(_mm_sub_ps(b, a), t));
}

template <int lane>
__m128 broadcast(__m128 v)
{
    return _mm_shuffle_ps(v, v, _MM_SHUFFLE(lane, lane, lane, lane));
}

inline __m128 load_pair(float const* pair)
{
    return _mm_castpd_ps(_mm_load_sd(reinterpret_cast<double const*>(pair)));
}

/// Two pairs, one behind the other.
inline __m128 pairs(float const* a, float const* b)
{
    return _mm_loadh_pi(load_pair(a), reinterpret_cast<__m64 const*>(b));
}

inline __m128i pairs(std::int32_t const* a, std::int32_t const* b)
{
    return _mm_unpacklo_epi64(_mm_loadl_epi64(reinterpret_cast<__m128i const*>(a)),
                              _mm_loadl_epi64(reinterpret_cast<__m128i const*>(b)));
}

/// Rounded down, in each lane; below 2^31.
struct Floored {
    explicit Floored(__m128 v)
    {
        __m128i const toward_zero = _mm_cvttps_epi32(v);
        __m128 const above = _mm_cmpgt_ps(_mm_cvtepi32_ps(toward_zero), v);
        whole = _mm_add_epi32(toward_zero, _mm_castps_si128(above));  // all bits set is -1
        fraction = _mm_sub_ps(v, _mm_cvtepi32_ps(whole));
    }
    __m128i whole;
    __m128 fraction;
};

/// Two lookups, a and b, each in a level of its own: between which texels they lie. `uvs`: u and v of a, u and v of b.
class TwoPlaces {
public:
    TwoPlaces(Mip const& a, Mip const& b, __m128 uvs)
    {
        Floored const st(_mm_sub_ps(_mm_mul_ps(uvs, pairs(a.size, b.size)), _mm_set1_ps(0.5f)));
        __m128i const mask = pairs(a.mask, b.mask);
        __m128i const low = _mm_and_si128(st.whole, mask);
        __m128i const high = _mm_and_si128(_mm_add_epi32(st.whole, _mm_set1_epi32(1)), mask);
        // As 16 bits: x and y of a, of b, and again of the next texels.
        __m128i const all = _mm_packs_epi32(low, high);
        std::int32_t row_a, row_b;
        std::memcpy(&row_a, a.row, sizeof row_a);
        std::memcpy(&row_b, b.row, sizeof row_b);
        __m128i const row = _mm_setr_epi32(row_a, row_b, row_a, row_b);
        constexpr int texel_bytes_log2 = 4;
        _mm_store_si128(reinterpret_cast<__m128i*>(rows_), _mm_slli_epi32(_mm_madd_epi16(all, row), texel_bytes_log2));
        _mm_store_si128(reinterpret_cast<__m128i*>(columns_),
                        _mm_slli_epi32(_mm_madd_epi16(all, _mm_set1_epi32(1)), texel_bytes_log2));
        fraction_ = st.fraction;
    }

    /// The bilinear value of lookup a (0) or b (1).
    template <int which>
    __m128 value(Mip const& mip) const
    {
        __m128 const fs = broadcast<2 * which>(fraction_);
        return mix(along_s<which>(mip, rows_[which], fs), along_s<which>(mip, rows_[which + 2], fs),
                   broadcast<2 * which + 1>(fraction_));
    }

private:
    template <int which>
    __m128 along_s(Mip const& mip, std::uint32_t row, __m128 fs) const
    {
        char const* const begin = reinterpret_cast<char const*>(mip.texels) + row;
        return mix(_mm_loadu_ps(reinterpret_cast<float const*>(begin + columns_[which])),
                   _mm_loadu_ps(reinterpret_cast<float const*>(begin + columns_[which + 2])), fs);
    }

    alignas(16) std::uint32_t rows_[4];  ///< in bytes: the lower ones of a and b, then the upper ones
    alignas(16) std::uint32_t columns_[4];
    __m128 fraction_;
};

/// (u, v, u, v)
inline __m128 twice(glm::vec2 const& uv)
{
    return pairs(&uv.x, &uv.x);
}

inline __m128 bilinear(Mip const& mip, __m128 uvuv)
{
    return TwoPlaces(mip, mip, uvuv).value<0>(mip);
}

/// The sum of two lookups in one level.
inline __m128 sum_of_two(Mip const& mip, __m128 uvs)
{
    TwoPlaces const places(mip, mip, uvs);
    return _mm_add_ps(places.value<0>(mip), places.value<1>(mip));
}

/// One lookup in two levels, interpolated with `weight`.
inline __m128 bilinear_in_both(Mip const& finer, Mip const& coarser, __m128 uvuv, __m128 weight)
{
    TwoPlaces const places(finer, coarser, uvuv);
    return mix(places.value<0>(finer), places.value<1>(coarser), weight);
}

/// x and y of four vectors, lane by lane.
struct Four {
    /// `of(i)` is a pointer to x and y of vector i.
    template <typename Of>
    explicit Four(Of const& of)
    {
        __m128 const low = pairs(of(0), of(1));
        __m128 const high = pairs(of(2), of(3));
        x = _mm_shuffle_ps(low, high, _MM_SHUFFLE(2, 0, 2, 0));
        y = _mm_shuffle_ps(low, high, _MM_SHUFFLE(3, 1, 3, 1));
    }
    __m128 x;
    __m128 y;
};

/// Footprints four by four; behind the last one it comes again.
class FourOf {
public:
    FourOf(Footprint const* footprints, std::size_t left)
    {
        for (std::size_t i = 0; i < 4; ++i)
            each_[i] = footprints + std::min(i, left - 1);
    }
    Footprint const& operator[](std::size_t i) const { return *each_[i]; }

private:
    Footprint const* each_[4];
};

inline __m128 times(__m128 a, float b)
{
    return _mm_mul_ps(a, _mm_set1_ps(b));
}

/// a + b x
inline __m128 linear(float a, float b, __m128 x)
{
    return _mm_add_ps(_mm_set1_ps(a), times(x, b));
}

/// log2 of normal numbers above 0, off by less than 2^-22 (1 + |log2 x|). Exponent and mantissa are taken apart, the
/// mantissa brought into [sqrt(1/2), sqrt(2)); the polynomial is that of logf in S. Moshier's Cephes library.
inline __m128 fast_log2(__m128 x)
{
    __m128i const root_of_half = _mm_set1_epi32(0x3f3504f3);
    __m128i const shifted = _mm_sub_epi32(_mm_castps_si128(x), root_of_half);
    __m128 const exponent = _mm_cvtepi32_ps(_mm_srai_epi32(shifted, 23));
    __m128i const mantissa = _mm_add_epi32(_mm_and_si128(shifted, _mm_set1_epi32(0x007fffff)), root_of_half);
    __m128 const f = _mm_sub_ps(_mm_castsi128_ps(mantissa), _mm_set1_ps(1));
    __m128 const f2 = _mm_mul_ps(f, f);
    // Pairs, so that the products do not wait for each other.
    __m128 const a = linear(3.3333331174e-1f, -2.4999993993e-1f, f);
    __m128 const b = linear(2.0000714765e-1f, -1.6668057665e-1f, f);
    __m128 const c = linear(1.4249322787e-1f, -1.2420140846e-1f, f);
    __m128 const d = linear(1.1676998740e-1f, -1.1514610310e-1f, f);
    __m128 const low = _mm_add_ps(a, _mm_mul_ps(b, f2));
    __m128 const high = _mm_add_ps(_mm_add_ps(c, _mm_mul_ps(d, f2)), times(_mm_mul_ps(f2, f2), 7.0376836292e-2f));
    __m128 const p = _mm_add_ps(low, _mm_mul_ps(_mm_mul_ps(f2, f2), high));
    __m128 const natural = _mm_add_ps(_mm_sub_ps(f, times(f2, 0.5f)), _mm_mul_ps(_mm_mul_ps(f2, f), p));
    return _mm_add_ps(exponent, times(natural, 1.44269504f));
}

/// Two neighbouring levels and the weight of the coarser one, for four footprints of so many texels of level 0: T is
/// log2 of these, kept to the levels that there are.
class LevelsOfFour {
public:
    LevelsOfFour(__m128 texels, int last)
    {
        // In this order NaN becomes 1.
        __m128 const t = _mm_min_ps(fast_log2(_mm_max_ps(texels, _mm_set1_ps(1))), _mm_set1_ps(float(last)));
        __m128 const above = _mm_max_ps(t, _mm_setzero_ps());
        __m128i const whole = _mm_cvttps_epi32(above);
        _mm_store_si128(reinterpret_cast<__m128i*>(finer), whole);
        _mm_store_ps(weight, _mm_sub_ps(above, _mm_cvtepi32_ps(whole)));
    }
    alignas(16) std::int32_t finer[4];  ///< there is a coarser one wherever its weight is above 0
    alignas(16) float weight[4];
};

inline void store(__m128 colour, glm::vec4& to)
{
    _mm_storeu_ps(&to.x, colour);
}
}  // namespace testat::bench
