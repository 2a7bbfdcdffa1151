#include "panorama.h"

#include "raster.h"
#include "shadow_grid.h"
#include "view_blocks.h"

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>

namespace {
int const width = 2048;
int const height = 1024;
int const tile_size = 16;
int const tiles_across = width / tile_size;
float const texel_angle = glm::pi<float>() / float(height);
/// Samples lie in the middles of the four quarters of a texel.
int const samples_across = 2;

/// Cosines and sines of the angles of samples, from the first angle on.
std::vector<glm::vec2> sample_angles(int count, float first)
{
    std::vector<glm::vec2> angles;
    for (int i = 0; i < count; ++i) {
        float const angle = first + (float(i) + 0.5f) * texel_angle / float(samples_across);
        angles.push_back(glm::vec2(std::cos(angle), std::sin(angle)));
    }
    return angles;
}

/// Bright light saturates softly, and little light fades, as on film. The root encodes for gamma 2.
glm::vec3 encoded(glm::vec3 const& light)
{
    glm::vec3 const exposed = 1.2f * light * light / (light + 0.1f);
    return glm::sqrt(1.f - glm::exp(-exposed));
}

/// The view from the origin, texel by texel.
class Panorama {
public:
    explicit Panorama(Room const& room);
    glm::vec3 color(int x, int y) const;

private:
    glm::vec3 direction(glm::ivec2 const& sample) const;
    ViewBlocks tile_blocks(glm::ivec2 const& tile) const;
    Hit look(BlockList const& seen, glm::ivec2 const& sample) const;

    Room const& room_;
    ShadowGrid shadows_;
    std::vector<glm::vec2> longitudes_;
    std::vector<glm::vec2> latitudes_;
    std::vector<ViewBlocks> tiles_;
};

Panorama::Panorama(Room const& room)
    : room_(room),
      shadows_(room),
      longitudes_(sample_angles(samples_across * width, -glm::pi<float>())),
      latitudes_(sample_angles(samples_across * height, -glm::half_pi<float>())),
      tiles_(std::size_t(tiles_across * height / tile_size))
{
    for_each_row(int(tiles_.size()), [&](int i) {
        tiles_[std::size_t(i)] = tile_blocks({i % tiles_across, i / tiles_across});
    });
}

glm::vec3 Panorama::direction(glm::ivec2 const& sample) const
{
    glm::vec2 const longitude = longitudes_[std::size_t(sample.x)];
    glm::vec2 const latitude = latitudes_[std::size_t(sample.y)];
    return glm::vec3(latitude.x * longitude.x, latitude.y, latitude.x * longitude.y);
}

ViewBlocks Panorama::tile_blocks(glm::ivec2 const& tile) const
{
    int const samples = samples_across * tile_size;
    glm::ivec2 const first = samples * tile;
    glm::vec3 const axis = direction(first + samples / 2);
    float cosine = 1.f;
    for (glm::ivec2 const& border : {glm::ivec2(0, 0), glm::ivec2(0, samples - 1), glm::ivec2(0, samples / 2)})
        cosine = std::min(cosine, glm::dot(axis, direction(first + border)));
    return find_view_blocks(room_, axis, std::acos(cosine) + 0.01f);
}

Hit Panorama::look(BlockList const& seen, glm::ivec2 const& sample) const
{
    glm::vec3 const d = direction(sample);
    Hit hit = trace(room_, seen, glm::vec3(0.f), d);
    hit.footprint = hit.t * texel_angle / std::max(std::abs(glm::dot(d, hit.normal)), 0.05f);
    return hit;
}

/// The mean of several samples. Patterns are blurred already: only where faces meet the third and fourth are needed.
/// Light varies slowly, but for that of the sun: it is found once for each face that the texel shows.
glm::vec3 Panorama::color(int x, int y) const
{
    static glm::ivec2 const places[] = {{0, 0}, {1, 1}, {1, 0}, {0, 1}};
    ViewBlocks const& blocks = tiles_[std::size_t(x / tile_size + y / tile_size * tiles_across)];
    glm::vec3 sum(0.f);
    glm::vec3 light(0.f);
    int lit_face = 0;
    int num_faces = 0;
    int num_samples = 0;
    for (; num_samples < (num_faces < 2 ? 2 : 4); ++num_samples) {
        Hit const hit = look(blocks.seen, samples_across * glm::ivec2(x, y) + places[num_samples]);
        if (num_faces == 0 || hit.face != lit_face) {
            light = arriving_light(room_, blocks.nearby, hit);
            lit_face = hit.face;
            ++num_faces;
        }
        Surface const surface = room_.surface(hit);
        sum += encoded(surface.emission + surface.albedo * (light + shadows_.sun_light(hit)));
    }
    return sum / float(num_samples);
}
}  // namespace

Image make_panorama(Room const& room)
{
    Panorama const panorama(room);
    return make_image(width, height, [&](int x, int y) { return panorama.color(x, y); });
}
