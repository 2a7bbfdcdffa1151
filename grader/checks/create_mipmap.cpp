#include "checks/mip_levels.h"
#include "checks/oracles.h"
#include "checks/vectors.h"

#include <fmt/format.h>

#include <algorithm>

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

Deviation sizes_deviation(Answers const& answers, std::uint32_t index, Textures const& textures, Words)
{
    auto const q = question<MipmapQuestion>(answers.group, index);
    return compare_sizes(read_mip_levels(answers, index), level_size(textures[q.texture], 0));
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
    add("SquareAverages", ask({TestTexture::mip_small, TestTexture::mip_square}), judge_by(mipmap_deviation));
    add("NonSquare",
        ask({TestTexture::mip_pair, TestTexture::mip_wide, TestTexture::mip_high, TestTexture::mip_row,
             TestTexture::mip_column, TestTexture::mip_single}),
        judge_by(mipmap_deviation));
}
}  // namespace testat
