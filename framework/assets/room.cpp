#include "room.h"

#include <algorithm>
#include <cmath>

namespace {
float const max_piece = 2.4f;
int const faces_per_block = 8;

/// Into the block's own axes, where it is not turned.
glm::vec3 unrolled(Block const& block, glm::vec3 const& v)
{
    glm::vec2 const r = block.roll;
    return glm::vec3(r.x * v.x + r.y * v.y, r.x * v.y - r.y * v.x, v.z);
}

glm::vec3 rolled(Block const& block, glm::vec3 const& v)
{
    glm::vec2 const r = block.roll;
    return glm::vec3(r.x * v.x - r.y * v.y, r.y * v.x + r.x * v.y, v.z);
}

/// Distance to where the ray enters the box, and the axis of the face; a negative distance if it misses.
struct Entry {
    float t;
    int axis;
};

Entry enter(Block const& block, glm::vec3 const& origin, glm::vec3 const& direction)
{
    glm::vec3 const center = unrolled(block, block.center - origin);
    glm::vec3 const d = 1.f / unrolled(block, direction);
    glm::vec3 const extent = glm::abs(d) * block.half_size;
    glm::vec3 const near = center * d - extent;
    glm::vec3 const far = center * d + extent;
    int const axis = near.x > near.y ? (near.x > near.z ? 0 : 2) : (near.y > near.z ? 1 : 2);
    float const t = near[axis];
    return {t <= std::min({far.x, far.y, far.z}) ? t : -1.f, axis};
}

/// Turned towards neighbouring faces near the edges.
glm::vec3 block_normal(Block const& block, glm::vec3 const& position, int axis)
{
    glm::vec3 const local = unrolled(block, position - block.center);
    glm::vec3 normal(0.f);
    if (block.bevel > 0.f)
        normal = glm::max(glm::abs(local) - block.half_size + block.bevel, 0.f) / block.bevel * glm::sign(local);
    normal[axis] = local[axis] > 0.f ? 1.f : -1.f;
    return rolled(block, glm::normalize(normal));
}

float distance_to(Block const& block, glm::vec3 const& p)
{
    glm::vec3 const outside = glm::abs(unrolled(block, p - block.center)) - block.half_size;
    return glm::length(glm::max(outside, 0.f)) + std::min(std::max({outside.x, outside.y, outside.z}), 0.f);
}

void add_pieces(Room& room, Block const& block, int axis, int count)
{
    for (int i = 0; i < count; ++i) {
        Block piece = block;
        glm::vec3 shift(0.f);
        piece.half_size[axis] /= float(count);
        shift[axis] = block.half_size[axis] * (float(2 * i + 1) / float(count) - 1.f);
        piece.center += rolled(block, shift);
        room.blocks.push_back(piece);
    }
}

void add_block(Room& room, Block const& block)
{
    glm::vec3 const h = block.half_size;
    int const axis = h.x > h.y ? (h.x > h.z ? 0 : 2) : (h.y > h.z ? 1 : 2);
    add_pieces(room, block, axis, std::max(1, int(2.f * h[axis] / max_piece)));
}

void meet_walls(Room const& room, glm::vec3 const& origin, glm::vec3 const& direction, Hit& hit)
{
    for (std::size_t i = 0; i < room.walls.size(); ++i) {
        Wall const& wall = room.walls[i];
        float const approach = -glm::dot(wall.normal, direction);
        float const t = (glm::dot(wall.normal, origin) + wall.offset) / approach;
        if (approach > 0.f && t < hit.t)
            hit = {t, {}, wall.normal, wall.material, -1 - int(i), 0.f};
    }
    hit.position = origin + hit.t * direction;
}
}  // namespace

void add_box(Room& room, glm::vec3 const& low, glm::vec3 const& high, int material, float bevel)
{
    Block const block = {0.5f * (low + high), 0.5f * (high - low), material, {1.f, 0.f}, bevel};
    // The bevel of a piece would show where it was cut.
    if (bevel > 0.f)
        room.blocks.push_back(block);
    else
        add_block(room, block);
}

void add_bar(Room& room, glm::vec3 const& from, glm::vec3 const& to, float half_width, int material)
{
    glm::vec3 const along = to - from;
    glm::vec3 const half_size(0.5f * glm::length(along), half_width, half_width);
    add_block(room, {0.5f * (from + to), half_size, material, glm::normalize(glm::vec2(along)), 0.f});
}

Hit trace(Room const& room, BlockList const& blocks, glm::vec3 const& origin, glm::vec3 const& direction)
{
    Hit hit = {1e9f, {}, {}, 0, 0, 0.f};
    meet_walls(room, origin, direction, hit);
    int nearest = -1;
    Entry entry = {hit.t, 0};
    for (int const i : blocks) {
        Entry const candidate = enter(room.blocks[std::size_t(i)], origin, direction);
        if (candidate.t > 0.f && candidate.t < entry.t) {
            entry = candidate;
            nearest = i;
        }
    }
    if (nearest < 0)
        return hit;
    Block const& block = room.blocks[std::size_t(nearest)];
    glm::vec3 const position = origin + entry.t * direction;
    return {entry.t,
            position,
            block_normal(block, position, entry.axis),
            block.material,
            nearest * faces_per_block + entry.axis,
            0.f};
}

float free_distance(Room const& room, BlockList const& blocks, glm::vec3 const& p)
{
    float distance = 1e9f;
    for (Wall const& wall : room.walls)
        distance = std::min(distance, glm::dot(wall.normal, p) + wall.offset);
    for (int const i : blocks)
        distance = std::min(distance, distance_to(room.blocks[std::size_t(i)], p));
    return distance;
}
