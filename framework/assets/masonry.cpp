#include "masonry.h"

#include "noise.h"

#include <algorithm>
#include <cmath>

namespace {
float const irregularity = 0.52f;
float const corner_radius = 0.13f;

/// i is outside by less than size.
int wrap(int i, int size)
{
    return i < 0 ? i + size : i < size ? i : i - size;
}

/// The smaller of both, with a round transition where they differ by less than radius.
float smooth_min(float a, float b, float radius)
{
    float const overlap = std::max(radius - std::abs(a - b), 0.f) / radius;
    return std::min(a, b) - 0.25f * radius * overlap * overlap;
}

/// Calls visit(stone) for all stones that can touch one near cell.
template <class Visit>
void for_each_neighbour(glm::ivec2 const& cell, Visit const& visit)
{
    for (int j = -1; j <= 1; ++j)
        for (int i = -2; i <= 2; ++i)
            visit(cell + glm::ivec2(i, j));
}
}  // namespace

Masonry::Masonry(int num_columns, int num_rows, std::uint32_t seed) : size_(num_columns, num_rows)
{
    for (int j = 0; j < num_rows; ++j)
        for (int i = 0; i < num_columns; ++i)
            jitter_.push_back(irregularity *
                              (glm::vec2(hash_to_unit(i, j, seed), hash_to_unit(i, j, seed + 1)) - 0.5f));
    for (int j = 0; j < num_rows; ++j)
        for (int i = 0; i < num_columns; ++i)
            sides_.push_back(find_sides(glm::ivec2(i, j)));
}

std::vector<Masonry::Side> Masonry::find_sides(glm::ivec2 const& stone) const
{
    std::vector<Side> sides;
    for_each_neighbour(stone, [&](glm::ivec2 const& other) {
        glm::vec2 const way = center(other) - center(stone);
        if (other != stone)
            sides.push_back({glm::normalize(way), 0.5f * glm::length(way)});
    });
    return sides;
}

std::size_t Masonry::index(glm::ivec2 const& stone) const
{
    return std::size_t(wrap(stone.x, size_.x) + wrap(stone.y, size_.y) * size_.x);
}

glm::vec2 Masonry::center(glm::ivec2 const& stone) const
{
    float const shift = stone.y % 2 == 0 ? 0.25f : 0.75f;
    return glm::vec2(stone) + glm::vec2(shift, 0.5f) + jitter_[index(stone)];
}

glm::ivec2 Masonry::nearest(glm::vec2 const& position, glm::ivec2 const& cell) const
{
    glm::ivec2 best = cell;
    float best_distance = 1e9f;
    for_each_neighbour(cell, [&](glm::ivec2 const& stone) {
        glm::vec2 const d = center(stone) - position;
        if (glm::dot(d, d) < best_distance) {
            best_distance = glm::dot(d, d);
            best = stone;
        }
    });
    return best;
}

float Masonry::border_distance(glm::ivec2 const& stone, glm::vec2 const& offset) const
{
    float distance = 1.f;
    for (Side const& side : sides_[index(stone)])
        distance = smooth_min(distance, side.distance - glm::dot(side.direction, offset), corner_radius);
    return distance;
}

StonePoint Masonry::find(glm::vec2 const& p) const
{
    glm::vec2 const position = p * glm::vec2(size_);
    glm::ivec2 const stone = nearest(position, glm::ivec2(glm::floor(position)));
    glm::ivec2 const name(wrap(stone.x, size_.x), wrap(stone.y, size_.y));
    return {name, position - center(stone), border_distance(stone, position - center(stone))};
}
