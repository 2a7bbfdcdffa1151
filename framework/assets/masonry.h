#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

/// Where a point of a wall lies in its stones.
struct StonePoint {
    /// The column and row of its stone, which name it.
    glm::ivec2 stone;
    /// From the middle of the stone, in stones.
    glm::vec2 offset;
    /// To the border of the stone, in stones: 0 between two of them, about 0.5 in the middle. Its lines of equal
    /// distance have round corners.
    float border;
};

/// A wall of irregular stones on [0, 1]^2 that continues at the opposite border.
class Masonry {
public:
    /// num_rows is even, as every other row is shifted by half a stone.
    Masonry(int num_columns, int num_rows, std::uint32_t seed);

    /// p may be outside by the size of a few stones.
    StonePoint find(glm::vec2 const& p) const;

private:
    /// A line between two stones, seen from the middle of one.
    struct Side {
        glm::vec2 direction;
        float distance;
    };

    /// Column and row may be outside.
    glm::vec2 center(glm::ivec2 const& stone) const;
    glm::ivec2 nearest(glm::vec2 const& position, glm::ivec2 const& cell) const;
    float border_distance(glm::ivec2 const& stone, glm::vec2 const& offset) const;
    std::vector<Side> find_sides(glm::ivec2 const& stone) const;
    std::size_t index(glm::ivec2 const& stone) const;

    glm::ivec2 size_;
    std::vector<glm::vec2> jitter_;
    std::vector<std::vector<Side>> sides_;
};
