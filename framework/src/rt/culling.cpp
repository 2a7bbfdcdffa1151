#include "culling.h"

#include <algorithm>
#include <cmath>
#include <limits>

// How far off a hit in float can be: the roundings of a transformed ray and of the hit itself are relative to how far
// away the origin is from the shape, and the inverse matrix magnifies them by the matrix' condition. `roundings` units
// of 2^-24 are several times what any order of evaluation adds up to; the price is boxes larger by a thousandth.
namespace {
float const roundings = 256.f * 0x1p-24f;

float norm(glm::mat3 const& m)
{
    return std::sqrt(glm::dot(m[0], m[0]) + glm::dot(m[1], m[1]) + glm::dot(m[2], m[2]));
}

/// In the Frobenius norm, over its smallest possible value, 3.
float condition(glm::mat4 const& matrix)
{
    glm::mat3 const linear(matrix);
    return norm(linear) * norm(glm::inverse(linear)) / 3.f;
}

float farthest(Bounds const& bounds)
{
    return glm::length(glm::max(glm::abs(bounds.lower), glm::abs(bounds.upper)));
}

/// Where the middle of a box comes on Morton's curve through `all`: the bits of x, y and z take turns.
std::uint32_t place_on_curve(Bounds const& bounds, Bounds const& all)
{
    glm::vec3 const size = glm::max(all.upper - all.lower, glm::vec3(FLT_MIN));
    glm::vec3 const middle = (0.5f * (bounds.lower + bounds.upper) - all.lower) / size;
    std::uint32_t place = 0;
    for (int bit = 9; bit >= 0; --bit)
        for (int axis = 0; axis < 3; ++axis)
            place = 2 * place + ((std::uint32_t(middle[axis] * 1023.f) >> bit) & 1u);
    return place;
}

/// Finite also for rays along an axis: 0 times infinity would be no number.
float inverse_of(float direction)
{
    float const smallest = 1e-20f;
    return 1.f / (std::abs(direction) > smallest ? direction : std::copysign(smallest, direction));
}
}  // namespace

Culling::Culling(std::vector<std::shared_ptr<Object>> const& objects, bool transformed)
{
    std::vector<Box> boxes;
    for (std::size_t i = 0; i < objects.size(); ++i)
        add(*objects[i], transformed ? objects[i]->transform_object_to_world : glm::mat4(1.f), int(i), &boxes);
    if (!boxes.empty())
        build_levels(std::move(boxes));
}

void Culling::add(Object const& object, glm::mat4 const& to_world, int index, std::vector<Box>* boxes)
{
    Bounds const bounds = object.geo->bounds(to_world);
    float const c = condition(to_world);
    auto const* plane = dynamic_cast<Plane const*>(object.geo.get());
    // Written so that NaN ends in the last case.
    if (bounds.is_finite() && c < 1e4f) {
        condition_ = std::max(condition_, c);
        // Roundings are relative to where things are, in the world and in the object's own space.
        float const scale = norm(glm::mat3(to_world));
        reach_ = std::max({reach_, farthest(bounds), scale * farthest(object.geo->bounds(glm::mat4(1.f)))});
        boxes->push_back({bounds, index});
    } else if (plane && to_world == glm::mat4(1.f)) {
        sides_.push_back({plane->center, plane->normal, index});
    } else {
        unbounded_.push_back(index);
    }
}

/// Boxes that are near each other along a space-filling curve share a block.
void Culling::build_levels(std::vector<Box> boxes)
{
    Bounds all = boxes.front().bounds;
    for (Box const& box : boxes)
        all = Bounds::around(all, box.bounds);
    std::stable_sort(boxes.begin(), boxes.end(), [&](Box const& a, Box const& b) {
        return place_on_curve(a.bounds, all) < place_on_curve(b.bounds, all);
    });
    std::size_t const few_blocks = 2;
    do {
        levels_.emplace_back();
        std::vector<Box> around_blocks;
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            int const lane = int(i) % lanes;
            if (lane == 0) {
                levels_.back().push_back(empty_block());
                around_blocks.push_back({boxes[i].bounds, int(levels_.back().size()) - 1});
            }
            fill_lane(levels_.back().back(), lane, boxes[i]);
            around_blocks.back().bounds = Bounds::around(around_blocks.back().bounds, boxes[i].bounds);
        }
        boxes = std::move(around_blocks);
    } while (levels_.back().size() > few_blocks);
}

Culling::Block Culling::empty_block()
{
    // Comparisons with what is no number fail: an empty lane is never met.
    float const nan = std::numeric_limits<float>::quiet_NaN();
    Floats const empty = {nan, nan, nan, nan};
    return {{empty, empty, empty}, {empty, empty, empty}, {}};
}

void Culling::fill_lane(Block& block, int lane, Box const& box)
{
    for (int axis = 0; axis < 3; ++axis) {
        block.lower[axis][lane] = box.bounds.lower[axis];
        block.upper[axis][lane] = box.bounds.upper[axis];
    }
    block.index[lane] = box.index;
}

Culling::Query Culling::make_query(Ray const& ray) const
{
    Query query;
    query.widen = roundings * condition_ * (glm::length(ray.origin) + reach_);
    for (int axis = 0; axis < 3; ++axis) {
        query.origin[axis] = ray.origin[axis];
        query.inverse[axis] = inverse_of(ray.direction[axis]);
    }
    return query;
}

/// A plane is out of reach where the ray starts on one side and is still there at t_max.
bool Culling::may_meet(Side const& side, Ray const& ray, float t_max) const
{
    float const start = glm::dot(ray.origin - side.center, side.normal);
    float const end = start + t_max * glm::dot(ray.direction, side.normal);
    float const margin = roundings * (glm::length(ray.origin) + glm::length(side.center));
    float const margin_at_end = margin + roundings * t_max;
    bool const above = start > margin && end > margin_at_end;
    bool const below = start < -margin && end < -margin_at_end;
    return !(above || below);
}
