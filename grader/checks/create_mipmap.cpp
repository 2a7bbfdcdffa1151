#include "checks/mip_levels.h"
#include "checks/oracles.h"
#include "checks/relations.h"
#include "checks/vectors.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace testat {
namespace {
using Sizes = std::vector<glm::ivec2>;

std::string format_sizes(Sizes const& sizes)
{
    std::string text;
    for (auto const& size : sizes)
        text += fmt::format("{}{} x {}", text.empty() ? "" : ", ", size.x, size.y);
    return text;
}

/// A 1 x 1 texture may end with one level or with two.
Deviation compare_sizes(MipLevels const& measured, glm::ivec2 size)
{
    Sizes const right = mip_sizes(size);
    bool const twice = size == glm::ivec2(1) && measured.sizes == Sizes{size, size};
    bool const complete = measured.count == measured.sizes.size();
    bool const equal = complete && (measured.sizes == right || twice);
    return {equal ? 0 : HUGE_VAL,
            fmt::format("mip_levels.size() = {}: {}", measured.count, format_sizes(measured.sizes)),
            format_sizes(right)};
}

Deviation compare_texels(MipLevels const& measured, TextureData const& texture, Words words)
{
    std::size_t const levels = std::min(measured.sizes.size(), mip_sizes(level_size(texture, 0)).size());
    Deviation worst;
    for (int level = 0; level < int(levels); ++level)
        for (int y = 0; y < measured.sizes[std::size_t(level)].y; ++y)
            for (int x = 0; x < measured.sizes[std::size_t(level)].x; ++x) {
                MipTexel const right = mip_texel(texture, level, x, y);
                std::vector<double> const bound(4, right.bound);
                glm::dvec4 const m = measured.texel(level, x, y);
                Deviation d = compare({m.x, m.y, m.z, m.w}, {right.mean.x, right.mean.y, right.mean.z, right.mean.w},
                                      bound, words);
                if (d.in_bounds <= worst.in_bounds)
                    continue;
                d.measured = fmt::format("get_texel({}, {}, {}) = {}", level, x, y, d.measured);
                worst = d;
            }
    return worst;
}

auto ask(std::vector<TestTexture> const& which)
{
    return [=](Random&, Textures const& textures) {
        std::vector<MipmapQuestion> questions;
        std::uint32_t texels = 0;
        for (TestTexture t : which) {
            questions.push_back({static_cast<std::uint32_t>(t)});
            texels = std::max(texels, mip_texel_count(level_size(at(textures, t), 0)));
        }
        Group group = make_group(Kind::mipmap, questions);
        group.words_per_answer = MipmapLayout::words(texels);
        return group;
    };
}

Deviation judge_sizes(MipLevels const& measured, TextureData const& texture)
{
    return compare_sizes(measured, level_size(texture, 0));
}

Deviation sizes_deviation(Answers const& answers, std::uint32_t index, Textures const& textures, Words)
{
    auto const q = question<MipmapQuestion>(answers.group, index);
    return judge_sizes(read_mip_levels(answers, index), textures[q.texture]);
}

constexpr std::array means = {TestTexture::mip_square, TestTexture::unknown_mip, TestTexture::unknown_mip_mean};

/// A texture that is known beforehand, one that is not, and their mean, in any order.
Group ask_means(Random& random, Textures const& textures)
{
    auto const order = unknown_order(textures, means.size());
    std::vector<TestTexture> asked(means.size());
    for (std::size_t i = 0; i < means.size(); ++i)
        asked[order[i]] = means[i];
    return ask(asked)(random, textures);
}

/// The mean's levels against the mean of the levels, texel by texel. Mistakes are linear, too, and some add up every
/// texel there is: as many roundings.
Deviation compare_means(MipLevels const& one, MipLevels const& two, MipLevels const& both)
{
    double const roundings = double(both.texels.size());
    for (std::size_t i = 0; i < both.texels.size(); ++i) {
        double const mean = (double(one.texels[i]) + two.texels[i]) / 2;
        double const bound = roundings * eps * std::abs(mean);
        if (std::isfinite(mean) && std::abs(both.texels[i] - mean) <= bound)
            continue;  // most are right: no words for them
        Deviation d = compare({both.texels[i]}, {mean}, {bound});
        d.measured = fmt::format("mean of a texel of T1 and T2: {}, of T3: {}", d.expected, d.measured);
        d.expected = "levels of T3 = mean of the levels of T1 and T2";
        return d;
    }
    return {};
}

/// More than half of the texels of level 0, at least, are different ones.
Deviation compare_variety(MipLevels const& levels)
{
    std::set<float> different;
    auto const count = std::size_t(levels.sizes[0].x) * std::size_t(levels.sizes[0].y);
    for (std::size_t i = 0; i < count; ++i)
        different.insert(levels.texels[4 * i]);
    return {2 * different.size() > count ? 0 : HUGE_VAL,
            fmt::format("{} different values of red in level 0 of {} texels", different.size(), count),
            "level 0 as it was"};
}

Verdict judge_means(Answers const& answers, Textures const& textures)
{
    auto const order = unknown_order(textures, means.size());
    MipLevels const one = read_mip_levels(answers, order[0]);
    MipLevels const two = read_mip_levels(answers, order[1]);
    MipLevels const both = read_mip_levels(answers, order[2]);
    Verdict verdict;
    for (std::size_t i = 0; i < means.size(); ++i)
        verdict.offer(order[i], judge_sizes(read_mip_levels(answers, order[i]), at(textures, means[i])));
    if (verdict.passed())
        verdict.offer(order[2], compare_means(one, two, both));
    if (verdict.passed())
        verdict.offer(order[2], compare_variety(both));
    return verdict;
}
}  // namespace

Deviation mipmap_deviation(Answers const& answers, std::uint32_t index, Textures const& textures, Words words)
{
    TextureData const& texture = textures[question<MipmapQuestion>(answers.group, index).texture];
    MipLevels const measured = read_mip_levels(answers, index);
    Deviation const sizes = compare_sizes(measured, level_size(texture, 0));
    return sizes.in_bounds <= 1 ? compare_texels(measured, texture, words) : sizes;
}

void add_create_mipmap_checks(std::vector<UnitCheck>& checks)
{
    auto const add = [&](char const* name, auto asked, auto judged) {
        checks.push_back({std::string("CreateMipmap.") + name, Function::create_mipmap, asked, judged});
    };
    add("SquareSizes", ask({TestTexture::mip_small, TestTexture::mip_square}), judge_by(sizes_deviation));
    add("SquareAverages", ask({TestTexture::mip_small, TestTexture::mip_square, TestTexture::unknown_mip}),
        judge_by(mipmap_deviation));
    add("NonSquare",
        ask({TestTexture::mip_pair, TestTexture::mip_wide, TestTexture::mip_high, TestTexture::mip_row,
             TestTexture::mip_column, TestTexture::mip_single, TestTexture::mip_long, TestTexture::mip_flat,
             TestTexture::unknown_mip_wide, TestTexture::unknown_mip_high}),
        judge_by(mipmap_deviation));
    checks.push_back({"CreateMipmap.LinearInTheTexture", Function::create_mipmap, ask_means, judge_means, true});
}
}  // namespace testat
