#pragma once

#include "room.h"

/// The blocks of a room by where they are seen from the sun, to find those in its way quickly.
class ShadowGrid {
public:
    /// Keeps a reference to the room.
    explicit ShadowGrid(Room const& room);

    /// The sun's light that arrives at a place.
    glm::vec3 sun_light(Hit const& hit) const;

private:
    glm::ivec2 cell(glm::vec2 const& seen) const;
    glm::vec2 seen_from_sun(glm::vec3 const& position) const;
    void add(int block);

    Room const& room_;
    glm::vec3 right_;
    glm::vec3 up_;
    std::vector<BlockList> cells_;
};
