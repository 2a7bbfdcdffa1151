#include "height_field.h"
#include "noise.h"
#include "raster.h"
#include "textures.h"
#include "wood.h"

#include <algorithm>
#include <cmath>

namespace {
int const size = 2048;
int const last_line = 18;
/// Of the texture's side, as the stones of the scene stand.
float const spacing = 0.0478515625f;
float const half_line = 2.f / float(size);
float const star_radius = 9.5f / float(size);
WoodCut const cut = {0.36f, 0.42f, 0.12f, 40.f, 101};

/// Number of the line next to a texture coordinate.
float nearest_line(float coordinate)
{
    return glm::clamp(std::floor((coordinate - 0.5f) / spacing + 9.5f), 0.f, float(last_line));
}

float line_position(float line)
{
    return 0.5f + (line - 9.f) * spacing;
}

bool has_star(float line)
{
    return line == 3.f || line == 9.f || line == 15.f;
}

/// To the nearest ink, negative in it, in units of the texture.
float ink_distance(glm::vec2 const& p)
{
    glm::vec2 const line(nearest_line(p.x), nearest_line(p.y));
    glm::vec2 const d(p.x - line_position(line.x), p.y - line_position(line.y));
    float const end = line_position(float(last_line)) - 0.5f + half_line;
    float const outside = std::max(std::abs(p.x - 0.5f), std::abs(p.y - 0.5f)) - end;
    float const lines = std::max(std::min(std::abs(d.x), std::abs(d.y)) - half_line, outside);
    return has_star(line.x) && has_star(line.y) ? std::min(lines, glm::length(d) - star_radius) : lines;
}

/// The rounded edge of the board: 0 inside, 1 at the border.
float edge(glm::vec2 const& p)
{
    float const inset = 0.5f - std::max(std::abs(p.x - 0.5f), std::abs(p.y - 0.5f));
    return 1.f - smooth_step(0.f, 0.006f, inset);
}

/// Softer than the ink, as the lacquer fills the lines.
float board_height(glm::vec2 const& p)
{
    WoodPoint const wood = wood_at(cut, p);
    float const groove = 1.f - smooth_step(-2.5f, 2.f, ink_distance(p) * float(size));
    return 0.9f * wood.ring + 0.8f * wood.fibre - 0.8f * wood.pore - 1.3f * groove - 4.f * edge(p);
}

glm::vec3 board_color(glm::vec2 const& p)
{
    glm::vec3 const wood = wood_color(wood_at(cut, p)) * (1.f - 0.35f * edge(p));
    glm::vec3 const ink = 0.16f * wood;
    return glm::mix(wood, ink, coverage(ink_distance(p) * float(size)));
}
}  // namespace

Image make_go_board_diffuse()
{
    return make_image(size, size, [](int x, int y) { return board_color(texel_center(x, y, size, size)); });
}

Image make_go_board_normal()
{
    HeightField const heights(size, size, Border::clamp,
                              [](int x, int y) { return board_height(texel_center(x, y, size, size)); });
    return make_normal_map(heights, Bitangent::along_v);
}
