#include "noise.h"
#include "raster.h"
#include "textures.h"

#include <glm/gtc/constants.hpp>

#include <cmath>
#include <vector>

namespace {
int const size = 256;
int const num_fibres = 9000;

/// How much light comes from each texel, around 0; tiles.
class Felt {
public:
    Felt() : light_(std::size_t(size) * std::size_t(size), 0.f)
    {
        for (int i = 0; i < num_fibres; ++i)
            add_fibre(i);
    }

    float light(int x, int y) const { return light_[index(x, y)]; }

private:
    static std::size_t index(int x, int y) { return std::size_t(x & (size - 1)) + std::size_t(y & (size - 1)) * size; }

    /// A short bent hair, lying in a direction of its own.
    void add_fibre(int i)
    {
        auto const random = [i](int j) { return hash_to_unit(i, j, 7); };
        glm::vec2 position = float(size) * glm::vec2(random(0), random(1));
        float angle = glm::two_pi<float>() * random(2);
        float const bend = 0.16f * (random(3) - 0.5f);
        float const strength = 0.16f * (random(4) - 0.45f);
        int const length = 8 + int(18.f * random(5));
        for (int step = 0; step < length; ++step) {
            splat(position, strength);
            position += glm::vec2(std::cos(angle), std::sin(angle));
            angle += bend;
        }
    }

    /// Shares strength among the four texels around a position.
    void splat(glm::vec2 const& position, float strength)
    {
        glm::vec2 const corner = glm::floor(position);
        glm::vec2 const f = position - corner;
        int const x = int(corner.x);
        int const y = int(corner.y);
        light_[index(x, y)] += strength * (1.f - f.x) * (1.f - f.y);
        light_[index(x + 1, y)] += strength * f.x * (1.f - f.y);
        light_[index(x, y + 1)] += strength * (1.f - f.x) * f.y;
        light_[index(x + 1, y + 1)] += strength * f.x * f.y;
    }

    std::vector<float> light_;
};
}  // namespace

Image make_pool_table()
{
    glm::vec3 const green(0.075f, 0.430f, 0.255f);
    Felt const felt;
    return make_image(size, size, [&](int x, int y) {
        glm::vec2 const p = texel_center(x, y, size, size);
        float const worn = 0.10f * (periodic_turbulence(8.f * p, 8, 3, 5) - 0.5f);
        float const grain = 0.10f * (hash_to_unit(x, y, 6) - 0.5f);
        return green * (1.f + worn + grain + felt.light(x, y));
    });
}
