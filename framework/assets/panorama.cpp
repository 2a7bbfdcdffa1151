#include "panorama.h"

#include "raster.h"
#include "shadow_grid.h"

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>

namespace {
int const width = 2048;
int const height = 1024;
int const tile_size = 16;
float const texel_angle = glm::pi<float>() / float(height);

/// x and y in texels.
glm::vec3 direction(float x, float y)
{
    float const longitude = x * texel_angle - glm::pi<float>();
    float const latitude = y * texel_angle - glm::half_pi<float>();
    float const horizontal = std::cos(latitude);
    return glm::vec3(horizontal * std::cos(longitude), std::sin(latitude), horizontal * std::sin(longitude));
}

/// The blocks that can be seen in a tile, and those that can darken what is seen.
struct TileBlocks {
    BlockList seen;
    BlockList nearby;
};

/// Whether a ball is met by a cone around axis that starts at the origin.
bool meets_cone(glm::vec3 const& center, float radius, glm::vec3 const& axis, float cone_angle)
{
    float const distance = glm::length(center);
    if (distance <= radius)
        return true;
    float const angle = std::acos(glm::clamp(glm::dot(center, axis) / distance, -1.f, 1.f));
    return angle <= cone_angle + std::asin(radius / distance);
}

TileBlocks tile_blocks(Room const& room, float x, float y)
{
    float const half = 0.5f * float(tile_size);
    glm::vec3 const axis = direction(x + half, y + half);
    float const cos_angle = std::min({glm::dot(axis, direction(x, y)), glm::dot(axis, direction(x, y + 2.f * half)),
                                      glm::dot(axis, direction(x, y + half))});
    float const cone_angle = std::acos(glm::clamp(cos_angle, -1.f, 1.f)) + 0.01f;
    TileBlocks blocks;
    for (std::size_t i = 0; i < room.blocks.size(); ++i) {
        float const radius = glm::length(room.blocks[i].half_size);
        if (meets_cone(room.blocks[i].center, radius, axis, cone_angle))
            blocks.seen.push_back(int(i));
        if (meets_cone(room.blocks[i].center, radius + occlusion_range, axis, cone_angle))
            blocks.nearby.push_back(int(i));
    }
    return blocks;
}

Hit look(Room const& room, BlockList const& seen, float x, float y)
{
    glm::vec3 const d = direction(x, y);
    Hit hit = trace(room, seen, glm::vec3(0.f), d);
    hit.footprint = hit.t * texel_angle / std::max(std::abs(glm::dot(d, hit.normal)), 0.05f);
    return hit;
}

/// Bright light saturates softly, and little light fades, as on film. The root encodes for gamma 2.
glm::vec3 encoded(glm::vec3 const& light)
{
    glm::vec3 const exposed = 1.2f * light * light / (light + 0.1f);
    return glm::sqrt(1.f - glm::exp(-exposed));
}

/// The mean of several samples. Patterns are blurred already: only where faces meet the third and fourth are needed.
/// Light varies slowly, but for that of the sun: it is found once for each face that the texel shows.
glm::vec3 texel_color(Room const& room, ShadowGrid const& shadows, TileBlocks const& blocks, int x, int y)
{
    static glm::vec2 const places[] = {{0.25f, 0.25f}, {0.75f, 0.75f}, {0.75f, 0.25f}, {0.25f, 0.75f}};
    glm::vec3 sum(0.f);
    glm::vec3 light(0.f);
    int lit_face = 0;
    int num_faces = 0;
    int num_samples = 0;
    for (; num_samples < (num_faces < 2 ? 2 : 4); ++num_samples) {
        glm::vec2 const place = glm::vec2(float(x), float(y)) + places[num_samples];
        Hit const hit = look(room, blocks.seen, place.x, place.y);
        if (num_faces == 0 || hit.face != lit_face) {
            light = arriving_light(room, blocks.nearby, hit);
            ++num_faces;
        }
        lit_face = hit.face;
        Surface const surface = room.surface(hit);
        sum += encoded(surface.emission + surface.albedo * (light + shadows.sun_light(hit)));
    }
    return sum / float(num_samples);
}
}  // namespace

Image make_panorama(Room const& room)
{
    ShadowGrid const shadows(room);
    int const num_columns = width / tile_size;
    std::vector<TileBlocks> tiles(std::size_t(num_columns) * std::size_t(height / tile_size));
    for_each_row(int(tiles.size()), [&](int i) {
        tiles[std::size_t(i)] =
            tile_blocks(room, float(i % num_columns * tile_size), float(i / num_columns * tile_size));
    });
    return make_image(width, height, [&](int x, int y) {
        return texel_color(room, shadows, tiles[std::size_t(x / tile_size + y / tile_size * num_columns)], x, y);
    });
}
