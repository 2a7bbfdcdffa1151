#pragma once

#include <glm/glm.hpp>

#include <vector>

// Rooms seen from inside, from the origin. Lengths are metres, y is up, light and colours are linear.

/// A plane that bounds the room: inside, dot(normal, p) + offset > 0. The normal is unit.
struct Wall {
    glm::vec3 normal;
    float offset;
    int material;
};

/// A box in the room.
struct Block {
    glm::vec3 center;
    glm::vec3 half_size;
    int material;
    /// Cosine and sine of the angle it is turned about z, from x to y.
    glm::vec2 roll = glm::vec2(1.f, 0.f);
    /// How round its edges look, in metres; its shape stays a box.
    float bevel = 0.f;
};

/// Light that leaves a place mainly in one direction, with the cosine of the angle to it.
struct Lamp {
    glm::vec3 position;
    glm::vec3 direction;
    glm::vec3 power;
};

/// What a ray meets.
struct Hit {
    float t;
    glm::vec3 position;
    glm::vec3 normal;
    int material;
    /// Differs from one face of a block, or wall, to another.
    int face;
    /// Extent of a texel on the surface, in metres.
    float footprint;
};

/// How a place looks.
struct Surface {
    glm::vec3 albedo;
    glm::vec3 emission = glm::vec3(0.f);
};

/// All there is in a room.
struct Room {
    std::vector<Wall> walls;
    std::vector<Block> blocks;
    std::vector<Lamp> lamps;
    /// Light from above and from below where nothing is in the way.
    glm::vec3 light_from_above;
    glm::vec3 light_from_below;
    /// To the sun, unit, not straight up.
    glm::vec3 sun_direction;
    /// On a surface that faces it.
    glm::vec3 sun_light;
    /// Never null, like sun_enters, where the room is shown.
    Surface (*surface)(Hit const&);
    /// How much of the sun enters towards a place, if no block is in the way.
    float (*sun_enters)(glm::vec3 const& position);
};

/// Indices of some of a room's blocks.
using BlockList = std::vector<int>;

/// Adds a box from low to high, cut into pieces that are not much longer than wide: culling wants compact blocks.
void add_box(Room& room, glm::vec3 const& low, glm::vec3 const& high, int material, float bevel = 0.f);

/// Adds a bar of square section from one point to another in a plane of constant z, cut likewise.
void add_bar(Room& room, glm::vec3 const& from, glm::vec3 const& to, float half_width, int material);

/// The nearest surface along a unit direction, among the walls and the blocks listed. footprint is left at 0.
Hit trace(Room const& room, BlockList const& blocks, glm::vec3 const& origin, glm::vec3 const& direction);

/// How far from p the nearest of the walls and the blocks listed is.
float free_distance(Room const& room, BlockList const& blocks, glm::vec3 const& p);

/// The light that arrives at a place: from all around and from lamps (without shadows), not from the sun.
/// nearby lists at least the blocks within occlusion_range of it.
glm::vec3 arriving_light(Room const& room, BlockList const& nearby, Hit const& hit);

/// Blocks farther away do not darken a place.
float const occlusion_range = 1.2f;
