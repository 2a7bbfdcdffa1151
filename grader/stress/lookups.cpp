#include "checks/vectors.h"
#include "stress/colours.h"
#include "stress/subjects.h"

// evaluate_nearest, evaluate_bilinear, evaluate_trilinear. Contract: uv and dudv finite, |u| W < 2^23 and |v| H < 2^23
// with the size of level 0, dudv >= 0, an existing level, sides from 1 to 16384, colours up to 1e30.
namespace testat {
namespace {
constexpr int textures_each = 8;
constexpr double farthest = 0x1p23;

/// Where mip maps count, sides are powers of two.
glm::ivec2 any_size(Random& random)
{
    if (random.coin())
        return power_of_two_size(random, 16384, 32768);
    glm::ivec2 const size(static_cast<int>(log_uniform(random, 1, 200)), static_cast<int>(log_uniform(random, 1, 200)));
    return size;
}

Wrap any_wrap(Random& random)
{
    return pick(random, {Wrap::repeat, Wrap::repeat, Wrap::clamp, Wrap::zero});
}

Textures coded_textures(Random& random)
{
    Textures textures;
    for (int i = 0; i < textures_each; ++i) {
        glm::ivec2 const size = any_size(random);
        textures.push_back(with_levels(size.x, size.y, any_wrap(random), coded));
    }
    return textures;
}

Textures coloured_textures(Random& random, bool powers_of_two)
{
    Textures textures;
    for (int i = 0; i < textures_each; ++i) {
        glm::ivec2 const size = powers_of_two ? power_of_two_size(random, 16384, 32768) : any_size(random);
        textures.push_back(with_levels(size.x, size.y, any_wrap(random), any_colour(random)));
    }
    return textures;
}

/// u with |u| * size < 2^23, for a level with a side of `texels`.
float coordinate(Random& random, int size, int texels)
{
    if (random.coin())  // any fraction of a texel, near enough that a float has digits for it
        return static_cast<float>(random.uniform(-3, 3));
    switch (random.integer(1, 4)) {
        case 1:  // a border or a centre, or one float beside it
            return next_to(random, static_cast<float>(random.integer(-4 * texels, 6 * texels) / (2.0 * texels)));
        case 2:  // denormal, zero, a period
            return pick(random,
                        {0.f, -0.f, denormal, -denormal, 1e-40f, -1e-40f, 1.f, -1.f, 0.99999994f, -0.99999994f});
        case 3: {
            float const last = std::nextafter(static_cast<float>(farthest / size), 0.f);
            return static_cast<float>(with_any_sign(random, pick(random, {last, last / 2, last / 3})));
        }
        default:
            return static_cast<float>(with_any_sign(random, log_uniform(random, 1e-44, 0.999 * farthest / size)));
    }
}

/// dudv in [0, infinity).
float extent(Random& random, int size)
{
    if (random.coin())
        return static_cast<float>(std::exp2(random.uniform(-1, 15)) / size);
    switch (random.integer(0, 2)) {
        case 0:  // whole levels, or one float beside them
            return next_to(random, static_cast<float>(std::exp2(random.integer(-2, 16)) / size));
        case 1:
            return pick(random, {0.f, 0.f, denormal, 1e-40f, 1.f, 1e30f, float_max});
        default:
            return static_cast<float>(log_uniform(random, 1e-44, 3e38));
    }
}

LookupQuestion inside(Random& random, Textures const& textures)
{
    LookupQuestion q{};
    q.texture = static_cast<std::uint32_t>(random.integer(0, int(textures.size()) - 1));
    TextureData const& texture = textures[q.texture];
    q.level = random.integer(0, int(texture.levels.size()) - 1);
    glm::ivec2 const size = level_size(texture, 0);
    glm::ivec2 const texels = level_size(texture, q.level);
    for (int i = 0; i < 2; ++i) {
        q.uv[i] = coordinate(random, size[i], texels[i]);
        q.dudv[i] = extent(random, size[i]);
    }
    return q;
}

/// Too far away, infinite, or not a number.
float far_away(Random& random, int size)
{
    if (random.coin())
        return pick(random, {float_nan, float_infinity, -float_infinity, float_max, -0x1p31f, 0x1p31f, 2147483520.f});
    return static_cast<float>(with_any_sign(random, log_uniform(random, farthest / size, 1e30)));
}

LookupQuestion outside(Random& random, Textures const& textures)
{
    LookupQuestion q = inside(random, textures);
    int const axis = random.integer(0, 1);
    q.uv[axis] = far_away(random, level_size(textures[q.texture], 0)[axis]);
    return q;
}

LookupQuestion outside_or_without_size(Random& random, Textures const& textures)
{
    if (random.coin())
        return outside(random, textures);
    LookupQuestion q = inside(random, textures);
    q.dudv[random.integer(0, 1)] = pick(random, {float_nan, float_infinity, -float_infinity, -1.f, -float_max});
    return q;
}

Block ask(Random& random, std::uint32_t count, Textures textures, LookupQuestion (*make)(Random&, Textures const&))
{
    Block block = make_block<LookupQuestion>(Kind::lookup, random, count, [&](Random& r) { return make(r, textures); });
    block.textures = std::move(textures);
    return block;
}
}  // namespace

Block texels_inside(Random& random, std::uint32_t questions)
{
    return ask(random, questions, coded_textures(random), inside);
}

Block lookups_inside(Random& random, std::uint32_t questions)
{
    return ask(random, questions, coloured_textures(random, false), inside);
}

Block lookups_outside(Random& random, std::uint32_t questions)
{
    return ask(random, questions, coloured_textures(random, false), outside);
}

Block filtered_inside(Random& random, std::uint32_t questions)
{
    return ask(random, questions, coloured_textures(random, true), inside);
}

Block filtered_outside(Random& random, std::uint32_t questions)
{
    return ask(random, questions, coloured_textures(random, true), outside_or_without_size);
}
}  // namespace testat
