#include "bench/filters.h"
#include "bench/filters/ellipse.h"
#include "bench/filters/taps.h"

#include <algorithm>

// A grid of probes over the footprint, in cells that are as square as their number allows: for 4 probes a row along the
// longer axis where it is twice as long as the other one, or else 2 x 2 (rows are those of McCormack et al., "Feline",
// 1999). A probe is bilinear, so that it averages texels of side p (variance p^2 / 12 along each axis) by a tent as
// wide as two of them (p^2 / 6). It does as much as its cell of width w, w^2 / 12, if p = w / sqrt(3); then n probes in
// a row have the variance of the whole row, (n w)^2 / 12, too.
namespace testat::bench {
namespace {
constexpr float texel_of_width = 0.57735027f;  // 1 / sqrt(3)
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
}  // namespace

LookUp prepare_anisotropic(TextureData const& texture, int probes)
{
    return by_ellipses(Anisotropic(texture, probes));
}
}  // namespace testat::bench
