#include "envelopes/pictures.h"

#include "answers.h"
#include "envelopes/mip_levels.h"

#include <limits>

namespace testat {
namespace {
Picture blank(int width, int height)
{
    return {width, height, std::vector<float>(3 * std::size_t(width) * std::size_t(height))};
}

float* pixel(Picture& picture, glm::ivec2 at)
{
    return &picture.rgb[3 * (std::size_t(at.y) * std::size_t(picture.width) + std::size_t(at.x))];
}

void draw_level(MipLevels const& levels, int level, Picture& picture)
{
    LevelPlace const place = place_of_level(level);
    bool const there = std::size_t(level) < levels.sizes.size() && levels.sizes[std::size_t(level)] == place.size;
    for (int y = 0; y < place.size.y; ++y)
        for (int x = 0; x < place.size.x; ++x) {
            glm::dvec4 const colour =
                there ? levels.texel(level, x, y) : glm::dvec4(std::numeric_limits<double>::quiet_NaN());
            for (int c = 0; c < 3; ++c)
                pixel(picture, place.corner + glm::ivec2(x, y))[c] = float(colour[c]);
        }
}

Picture draw_levels(MipLevels const& levels)
{
    Picture picture = blank(checker_side * 3 / 2, checker_side);
    for (int level = 0; level < checker_levels; ++level)
        draw_level(levels, level, picture);
    return picture;
}
}  // namespace

LevelPlace place_of_level(int level)
{
    if (level == 0)
        return {{0, 0}, glm::ivec2(checker_side)};
    int const side = checker_side >> level;
    // Sides 64, 32, ... stacked: each level begins where the one before ends.
    int const below = checker_side - 2 * side;
    return {{checker_side, below}, glm::ivec2(side)};
}

namespace {
bool has(std::string const& picture, char const* part)
{
    return picture.find(part) != std::string::npos;
}

FunctionSet set_of(std::initializer_list<Function> functions)
{
    FunctionSet set;
    for (Function f : functions)
        set = set.with(f);
    return set;
}

}  // namespace

bool is_transformed(std::string const& picture)
{
    return has(picture, "_after_e") || has(picture, "_after_f");
}

FunctionSet called_in(std::string const& picture)
{
    if (picture == miplevels)
        return set_of({Function::create_mipmap});
    if (has(picture, "_dudv"))
        return set_of({Function::compute_uv_aabb_size});
    FunctionSet called;
    if (has(picture, "_after_d"))
        called = set_of({Function::create_mipmap, Function::compute_uv_aabb_size, Function::evaluate_trilinear,
                         Function::evaluate_bilinear});
    else
        called = called.with(has(picture, "_after_c") ? Function::evaluate_bilinear : Function::evaluate_nearest);
    // The board's textures repeat whatever the mode of the others is.
    if (has(picture, "goboard") || !(has(picture, "_zero") || has(picture, "_debugmip")))
        called = called.with(has(picture, "_clamp") ? Function::wrap_clamp : Function::wrap_repeat);
    if (is_transformed(picture))
        called = called | set_of({Function::transform_direction, Function::transform_position, Function::intersect});
    return has(picture, "_after_f") ? called.with(Function::transform_direction_to_object_space) : called;
}

FunctionSet functions_in(std::string const& picture)
{
    FunctionSet const called = called_in(picture);
    if (has(picture, "_dudv"))
        return called.with(Function::intersect);
    FunctionSet const lookups =
        set_of({Function::evaluate_nearest, Function::wrap_clamp, Function::wrap_repeat, Function::evaluate_bilinear});
    return lookups | (picture == miplevels ? called : called.with(Function::intersect));
}

Group picture_group(std::string const& picture)
{
    PictureQuestion q{};
    picture.copy(q.name, sizeof q.name - 1);
    Group group = make_group(Kind::picture, std::vector<PictureQuestion>{q});
    group.words_per_answer = picture == miplevels ? MipmapLayout::words(mip_texel_count(glm::ivec2(checker_side)))
                                                  : 3 * picture_side * picture_side;
    return group;
}

std::optional<Picture> read_picture(Answers const& answers)
{
    if (answers.status.ended != Ended::answered)
        return std::nullopt;
    if (question<PictureQuestion>(answers.group, 0).name == std::string(miplevels))
        return draw_levels(read_mip_levels(answers, 0));
    Picture picture = blank(picture_side, picture_side);
    std::memcpy(picture.rgb.data(), answers.words.data(), 4 * picture.rgb.size());
    return picture;
}
}  // namespace testat
