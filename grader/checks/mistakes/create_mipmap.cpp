#include "checks/mip_levels.h"
#include "checks/mistakes/mistake.h"
#include "checks/vectors.h"

#include <algorithm>

namespace testat {
namespace {
struct Level {
    glm::ivec2 size;
    std::vector<glm::dvec4> texels;

    glm::dvec4& at(int x, int y) { return texels[std::size_t(y) * std::size_t(size.x) + std::size_t(x)]; }
};

Level blank(glm::ivec2 size)
{
    return {size, std::vector<glm::dvec4>(std::size_t(size.x) * std::size_t(size.y), glm::dvec4(0))};
}

/// One wrong pyramid.
struct Rule {
    bool (*ends)(glm::ivec2 size);         ///< whether this level is the last one
    glm::ivec2 unwritten{0};               ///< columns and rows that stay black
    double brighter = 1;                   ///< factor of each level
    double narrow_brighter = 1;            ///< the same where blocks are 2 x 1 or 1 x 2
    std::optional<glm::ivec2> taken = {};  ///< texel of the block that is taken instead of the mean
    glm::ivec2 averaged = glm::ivec2(2);   ///< texels of the block that count
    std::optional<double> alpha = {};      ///< of all levels but the first
    bool only_in_zero_mode = false;        ///< narrow_brighter counts there alone: the wrap mode gives the second texel
};

glm::dvec4 mean(Level& finer, glm::ivec2 corner, glm::ivec2 count)
{
    glm::dvec4 sum(0);
    for (int j = 0; j < count.y; ++j)
        for (int i = 0; i < count.x; ++i)
            sum += finer.at(corner.x + i, corner.y + j);
    return sum / double(count.x * count.y);
}

glm::dvec4 combine(Level& finer, glm::ivec2 corner, glm::ivec2 block, Rule const& rule)
{
    if (rule.taken) {
        glm::ivec2 const place = corner + glm::min(*rule.taken, block - 1);
        return finer.at(place.x, place.y);
    }
    bool const narrow = block != glm::ivec2(2);
    glm::dvec4 colour = mean(finer, corner, glm::min(block, rule.averaged));
    colour *= narrow ? rule.narrow_brighter : rule.brighter;
    colour.a = rule.alpha.value_or(colour.a);
    return colour;
}

Level next_level(Level& finer, Rule const& rule)
{
    Level coarser = blank(glm::max(finer.size / 2, glm::ivec2(1)));
    glm::ivec2 const block = finer.size / coarser.size;
    for (int y = 0; y < coarser.size.y - rule.unwritten.y; ++y)
        for (int x = 0; x < coarser.size.x - rule.unwritten.x; ++x)
            coarser.at(x, y) = combine(finer, {x * block.x, y * block.y}, block, rule);
    return coarser;
}

std::vector<Level> pyramid(TextureData const& texture, Rule rule)
{
    if (rule.only_in_zero_mode && texture.wrap_mode != static_cast<std::uint32_t>(Wrap::zero))
        rule.narrow_brighter = 1;
    Level finest = blank(level_size(texture, 0));
    for (int y = 0; y < finest.size.y; ++y)
        for (int x = 0; x < finest.size.x; ++x)
            finest.at(x, y) = texel(texture, 0, x, y);
    std::vector<Level> levels{finest};
    while (!rule.ends(levels.back().size))
        levels.push_back(next_level(levels.back(), rule));
    return levels;
}

bool is_close(glm::dvec4 measured, glm::dvec4 expected)
{
    for (int c = 0; c < 4; ++c)
        if (!(std::abs(measured[c] - expected[c]) <= 64 * eps * (1 + std::abs(expected[c]))))
            return false;
    return true;
}

bool equals(MipLevels const& measured, int level, Level& expected)
{
    for (int y = 0; y < expected.size.y; ++y)
        for (int x = 0; x < expected.size.x; ++x)
            if (!is_close(measured.texel(level, x, y), expected.at(x, y)))
                return false;
    return true;
}

Model model(Rule const& rule)
{
    return {[=](Answers const& answers, std::uint32_t i, Textures const& textures) {
                MipLevels const measured = read_mip_levels(answers, i);
                auto levels = pyramid(textures[question<MipmapQuestion>(answers.group, i).texture], rule);
                if (measured.count != levels.size() || measured.sizes.size() != levels.size())
                    return false;
                for (std::size_t level = 0; level < levels.size(); ++level)
                    if (measured.sizes[level] != levels[level].size || !equals(measured, int(level), levels[level]))
                        return false;
                return true;
            },
            nullptr};
}

bool at_one_texel(glm::ivec2 size)
{
    return size == glm::ivec2(1);
}

bool at_shorter_side(glm::ivec2 size)
{
    return size.x == 1 || size.y == 1;
}

bool at_two_texels(glm::ivec2 size)
{
    return size.x <= 2 && size.y <= 2;
}

bool at_level_zero(glm::ivec2)
{
    return true;
}

Rule rule(bool (*ends)(glm::ivec2))
{
    return {ends};
}

Rule unwritten(glm::ivec2 columns_and_rows)
{
    return {at_one_texel, columns_and_rows};
}

Rule brighter(double factor, double narrow_factor)
{
    return {at_one_texel, {}, factor, narrow_factor};
}

Rule taken(glm::ivec2 texel)
{
    return {at_one_texel, {}, 1, 1, texel};
}

Rule averaged(glm::ivec2 texels)
{
    return {at_one_texel, {}, 1, 1, {}, texels};
}

Rule with_alpha(double alpha)
{
    Rule changed = rule(at_one_texel);
    changed.alpha = alpha;
    return changed;
}

/// Always the mean of four texels by get_texel.
Rule beyond_the_border()
{
    Rule changed = brighter(1, 0.5);
    changed.only_in_zero_mode = true;
    return changed;
}
}  // namespace

void add_create_mipmap_mistakes(std::vector<Mistake>& mistakes)
{
    auto const add = [&](char const* id, std::vector<Rule> const& rules) {
        Mistake mistake{id, Function::create_mipmap, {}};
        for (auto const& r : rules)
            mistake.models.push_back(model(r));
        mistakes.push_back(std::move(mistake));
    };
    add("mipmap_stops_at_shorter_side", {rule(at_shorter_side)});
    add("mipmap_forgets_last_level", {rule(at_two_texels)});
    add("mipmap_stays_at_level_zero", {rule(at_level_zero)});
    add("mipmap_misses_last_row", {unwritten({1, 1}), unwritten({1, 0}), unwritten({0, 1})});
    add("mipmap_leaves_levels_empty", {brighter(0, 0)});
    add("mipmap_takes_one_texel", {taken({0, 0}), taken({1, 0}), taken({0, 1}), taken({1, 1})});
    add("mipmap_averages_two_texels", {averaged({2, 1}), averaged({1, 2})});
    add("mipmap_forgets_division",
        {brighter(4, 2), brighter(4, 4), brighter(2, 2), brighter(2, 1), brighter(0.5, 0.5)});
    add("mipmap_divides_two_by_four", {brighter(1, 0.5), beyond_the_border()});
    add("mipmap_loses_alpha", {with_alpha(0), with_alpha(1)});
}
}  // namespace testat
