#include "checks/textures.h"

#include "checks/random.h"

#include <algorithm>

namespace testat {
namespace {
TextureData::Level make_level(int level, int width, int height, Colour const& colour)
{
    TextureData::Level made{width, height, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            glm::vec4 const c = colour(level, x, y);
            made.texels.insert(made.texels.end(), {c.r, c.g, c.b, c.a});
        }
    return made;
}

TextureData level_zero_only(int width, int height, Colour const& colour, Wrap wrap = Wrap::repeat)
{
    return {static_cast<std::uint32_t>(wrap), {make_level(0, width, height, colour)}};
}

/// Independent colours in [0, 1), multiples of 2^-12.
Colour noise(Random& random)
{
    return [&random](int, int, int) {
        glm::vec4 c;
        for (int i = 0; i < 4; ++i)
            c[i] = float(random.integer(0, 4095)) / 4096.f;
        return c;
    };
}

Colour opaque(Colour const& colour)
{
    return [=](int level, int x, int y) { return glm::vec4(glm::vec3(colour(level, x, y)), 1.f); };
}

/// From [0, 1) to [-2, 4): what clamps colours shows.
Colour stretched(Colour const& colour)
{
    return [=](int level, int x, int y) { return 6.f * colour(level, x, y) - 2.f; };
}

/// Any two neighbours differ by at least a quarter, also across the seam.
float stripe(int i)
{
    constexpr float values[] = {0.125f,  0.75f, 0.25f,   1.f,     0.f,     0.875f,  0.375f,  0.625f,
                                0.0625f, 0.5f,  0.9375f, 0.3125f, 0.6875f, 0.1875f, 0.8125f, 0.4375f};
    return values[i % 16];
}

glm::vec4 stripes(int, int x, int y)
{
    return {stripe(x), stripe(15 - x), stripe(y), 1.f};
}

/// As `like`, with other colours.
TextureData recoloured(TextureData like, Colour const& colour)
{
    for (int level = 0; level < int(like.levels.size()); ++level) {
        glm::ivec2 const size = level_size(like, level);
        like.levels[std::size_t(level)] = make_level(level, size.x, size.y, colour);
    }
    return like;
}

/// Exact in float where both are multiples of 2^-12.
TextureData mean(TextureData const& a, TextureData const& b)
{
    return recoloured(
        a, [&](int level, int x, int y) { return glm::vec4(0.5 * (texel(a, level, x, y) + texel(b, level, x, y))); });
}

TextureData mirrored(TextureData const& texture)
{
    return recoloured(texture, [&](int level, int x, int y) {
        glm::ivec2 const size = level_size(texture, level);
        return glm::vec4(texel(texture, level, size.x - 1 - x, size.y - 1 - y));
    });
}

TextureData shifted(TextureData const& texture, glm::ivec2 shift)
{
    return recoloured(
        texture, [&](int level, int x, int y) { return glm::vec4(texel(texture, level, x - shift.x, y - shift.y)); });
}

TextureData without_level_zero(TextureData texture)
{
    texture.levels.erase(texture.levels.begin());
    return texture;
}

void add_unknown_textures(Random& random, Textures& textures)
{
    auto const noisy = noise(random);
    TextureData const unknown_mip = level_zero_only(64, 64, noisy);
    TextureData const unknown = with_levels(32, 32, Wrap::repeat, noisy);
    TextureData const both = mean(at(textures, TestTexture::noise_square), unknown);
    textures.push_back(unknown_mip);
    textures.push_back(mean(at(textures, TestTexture::mip_square), unknown_mip));
    textures.push_back(level_zero_only(16, 4, noisy));
    textures.push_back(level_zero_only(2, 16, noisy));
    textures.push_back(unknown);
    textures.push_back(mirrored(both));
    textures.push_back(without_level_zero(mirrored(both)));
    textures.push_back(shifted(both, texture_shift));
}

int wrapped(int i, int size, Wrap wrap)
{
    if (wrap == Wrap::clamp)
        return std::clamp(i, 0, size - 1);
    int const remainder = i % size;
    return remainder < 0 ? remainder + size : remainder;
}
}  // namespace

TextureData with_levels(int width, int height, Wrap wrap, Colour const& colour)
{
    TextureData texture{static_cast<std::uint32_t>(wrap), {}};
    for (int level = 0;; ++level) {
        texture.levels.push_back(make_level(level, width, height, colour));
        if (width == 1 && height == 1)
            return texture;
        width = std::max(1, width / 2);
        height = std::max(1, height / 2);
    }
}

glm::vec4 coded(int level, int x, int y)
{
    return {float(level), float(x), float(y), 1.f};
}

Textures make_test_textures(std::uint64_t seed, std::string_view upload_sha256)
{
    Random random(seed, "textures");
    glm::vec4 const one_colour = opaque(noise(random))(0, 0, 0) + glm::vec4(0.125f, 0.125f, 0.125f, 0.f);
    auto const constant = [=](int, int, int) { return one_colour; };
    auto const noisy = noise(random);
    Textures textures;
    textures.push_back(with_levels(16, 16, Wrap::repeat, coded));
    textures.push_back(with_levels(32, 8, Wrap::repeat, coded));
    textures.push_back(with_levels(32, 8, Wrap::zero, coded));
    textures.push_back(with_levels(32, 8, Wrap::clamp, coded));
    textures.push_back(with_levels(8, 8, Wrap::repeat, constant));
    textures.push_back(with_levels(32, 32, Wrap::repeat, opaque(noisy)));
    textures.push_back(with_levels(64, 16, Wrap::repeat, noisy));
    textures.push_back(with_levels(16, 64, Wrap::repeat, noisy));
    for (Wrap const wrap : {Wrap::repeat, Wrap::clamp, Wrap::zero})
        textures.push_back(with_levels(16, 16, wrap, stripes));
    Random more(seed, "more textures");
    textures.push_back(with_levels(512, 2, Wrap::repeat, noise(more)));
    for (glm::ivec2 const size : {glm::ivec2(8, 8), {64, 64}, {32, 8}, {4, 64}, {16, 1}, {1, 16}, {2, 1}, {1, 1}})
        textures.push_back(level_zero_only(size.x, size.y, noisy));
    textures.push_back(level_zero_only(1, 1024, stretched(noise(more)), Wrap::zero));
    textures.push_back(level_zero_only(1024, 1, stretched(noise(more)), Wrap::zero));
    textures.push_back(level_zero_only(32, 32, opaque(stretched(noise(more)))));
    Random unknown(seed, std::string("unknown textures").append(upload_sha256));
    add_unknown_textures(unknown, textures);
    return textures;
}

glm::ivec2 level_size(TextureData const& texture, int level)
{
    auto const& data = texture.levels.at(std::size_t(level));
    return {data.width, data.height};
}

glm::dvec4 texel(TextureData const& texture, int level, int x, int y)
{
    auto const& data = texture.levels.at(std::size_t(level));
    auto const wrap = static_cast<Wrap>(texture.wrap_mode);
    bool const inside = x >= 0 && x < data.width && y >= 0 && y < data.height;
    if (wrap == Wrap::zero && !inside)
        return glm::dvec4(0);
    auto const column = std::size_t(wrapped(x, data.width, wrap));
    auto const row = std::size_t(wrapped(y, data.height, wrap));
    float const* at = &data.texels[4 * (row * std::size_t(data.width) + column)];
    return {at[0], at[1], at[2], at[3]};
}
}  // namespace testat
