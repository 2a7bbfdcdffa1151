#include "envelopes/mip_levels.h"
#include "stress/colours.h"
#include "stress/subjects.h"

#include <algorithm>

// create_mipmap. Contract: sides are powers of two from 1 to 16384, colours finite and up to 1e30, so that no sum
// overflows.
namespace testat {
namespace {
TextureData one_level(glm::ivec2 size, Colour const& colour)
{
    TextureData texture = with_levels(size.x, size.y, Wrap::repeat, colour);
    texture.levels.resize(1);
    return texture;
}

/// A texture for each question: what create_mipmap does to one must not be seen by another.
template <typename MakeTexture>
Block ask(std::uint32_t count, MakeTexture const& make_texture)
{
    Textures textures;
    std::vector<MipmapQuestion> questions;
    std::uint32_t texels = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
        textures.push_back(make_texture());
        texels = std::max(texels, mip_texel_count(level_size(textures.back(), 0)));
        questions.push_back({i});
    }
    Block block{std::move(textures), make_group(Kind::mipmap, questions)};
    block.group.words_per_answer = MipmapLayout::words(texels);
    return block;
}

/// Some blocks hold large textures, most small ones.
int any_area(Random& random)
{
    return pick(random, {64, 64, 64, 1024, 1024, 1024, 4096, 32768});
}

/// With NaN, infinity, or numbers whose sum overflows among its colours.
Colour beyond_numbers(Random& random)
{
    return [&random](int, int, int) {
        float const odd = pick(random, {float_nan, float_infinity, -float_infinity, float_max, -float_max});
        return seldom(random, 4) ? glm::vec4(odd) : glm::vec4(0.5f);
    };
}
}  // namespace

Block mipmaps_inside(Random& random, std::uint32_t questions)
{
    int const area = any_area(random);
    return ask(questions,
               [&] { return one_level(power_of_two_size(random, std::min(area, 16384), area), any_colour(random)); });
}

Block mipmaps_outside(Random& random, std::uint32_t questions)
{
    return ask(questions, [&] {
        if (random.coin())
            return one_level(power_of_two_size(random, 64, 64), beyond_numbers(random));
        return one_level({random.integer(1, 100), random.integer(1, 9)}, any_colour(random));
    });
}
}  // namespace testat
