#pragma once

#include <glm/glm.hpp>

#include <vector>

/// A straight piece of a stroke.
struct Segment {
    glm::vec2 from;
    glm::vec2 to;
};

/// The strokes of a number, whose digits are 1 high; its middle is (0, 0), x grows to the right and y upward.
/// 6 and 9 are underlined, so that they differ on a ball. number >= 0.
std::vector<Segment> number_strokes(int number);

/// From p to the nearest stroke, drawn half_width to both sides; negative in it.
float stroke_distance(std::vector<Segment> const& strokes, glm::vec2 const& p, float half_width);
