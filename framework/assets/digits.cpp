#include "digits.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace {
using Strokes = std::vector<Segment>;

glm::vec2 const digit_middle(0.3f, 0.5f);
float const digit_pitch = 0.86f;

/// Part of an ellipse, counterclockwise where `to` is larger.
struct Arc {
    glm::vec2 center;
    glm::vec2 radii;
    float from_degrees;
    float to_degrees;
};

glm::vec2 arc_point(Arc const& arc, float t)
{
    float const angle = glm::radians(glm::mix(arc.from_degrees, arc.to_degrees, t));
    return arc.center + arc.radii * glm::vec2(std::cos(angle), std::sin(angle));
}

void add(Strokes& strokes, Arc const& arc)
{
    int const count = 24;
    for (int i = 0; i < count; ++i)
        strokes.push_back({arc_point(arc, float(i) / float(count)), arc_point(arc, float(i + 1) / float(count))});
}

/// Lines, then arcs.
Strokes shape(Strokes strokes, std::vector<Arc> const& arcs)
{
    for (Arc const& arc : arcs)
        add(strokes, arc);
    return strokes;
}

/// In a field 0.6 wide and 1 high.
Strokes digit_strokes(int digit)
{
    switch (digit) {
        case 0:
            return shape({}, {{{.3f, .5f}, {.28f, .5f}, 0.f, 360.f}});
        case 1:
            return shape({{{.10f, .76f}, {.36f, 1.f}}, {{.36f, 1.f}, {.36f, 0.f}}}, {});
        case 2:
            return shape({{{.537f, .528f}, {.03f, 0.f}}, {{.03f, 0.f}, {.57f, 0.f}}},
                         {{{.3f, .7f}, {.29f, .3f}, 168.f, -35.f}});
        case 3:
            return shape({},
                         {{{.29f, .755f}, {.25f, .245f}, 155.f, -90.f}, {{.29f, .255f}, {.29f, .255f}, 90.f, -158.f}});
        case 4:
            return shape({{{.42f, 0.f}, {.42f, 1.f}}, {{.42f, 1.f}, {0.f, .28f}}, {{0.f, .28f}, {.6f, .28f}}}, {});
        case 5:
            return shape({{{.54f, 1.f}, {.11f, 1.f}}, {{.11f, 1.f}, {.07f, .55f}}},
                         {{{.28f, .33f}, {.30f, .33f}, 134.f, -152.f}});
        case 6:
            return shape({}, {{{.3f, .31f}, {.29f, .31f}, 0.f, 360.f}, {{.6f, .31f}, {.59f, .69f}, 180.f, 100.f}});
        case 7:
            return shape({{{.02f, 1.f}, {.58f, 1.f}}, {{.58f, 1.f}, {.2f, 0.f}}}, {});
        case 8:
            return shape({}, {{{.3f, .755f}, {.24f, .245f}, 0.f, 360.f}, {{.3f, .255f}, {.29f, .255f}, 0.f, 360.f}});
        default:
            return shape({}, {{{.3f, .69f}, {.29f, .31f}, 0.f, 360.f}, {{0.f, .69f}, {.59f, .69f}, 0.f, -80.f}});
    }
}

void append(Strokes& strokes, Strokes const& more, glm::vec2 const& shift)
{
    for (Segment const& segment : more)
        strokes.push_back({segment.from + shift, segment.to + shift});
}

float segment_distance(Segment const& segment, glm::vec2 const& p)
{
    glm::vec2 const along = segment.to - segment.from;
    float const t = glm::clamp(glm::dot(p - segment.from, along) / glm::dot(along, along), 0.f, 1.f);
    return glm::length(p - segment.from - t * along);
}
}  // namespace

Strokes number_strokes(int number)
{
    Strokes strokes;
    std::string const digits = std::to_string(number);
    float x = -0.5f * digit_pitch * float(digits.size() - 1);
    for (char const digit : digits) {
        append(strokes, digit_strokes(digit - '0'), glm::vec2(x, 0.f) - digit_middle);
        x += digit_pitch;
    }
    if (number == 6 || number == 9)
        strokes.push_back({{-0.26f, -0.78f}, {0.26f, -0.78f}});
    return strokes;
}

float stroke_distance(Strokes const& strokes, glm::vec2 const& p, float half_width)
{
    float distance = 1e9f;
    for (Segment const& segment : strokes)
        distance = std::min(distance, segment_distance(segment, p));
    return distance - half_width;
}
