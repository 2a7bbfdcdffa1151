#include "bench/filters.h"

#include <cglib/rt/texture.h>
#include <cglib/rt/texture_access.h>

#include <cstring>

namespace testat::bench {
namespace {
std::shared_ptr<Image> make_image(TextureData::Level const& level)
{
    auto image = std::make_shared<Image>(level.width, level.height);
    auto& pixels = image->getPixels();
    std::memcpy(pixels.data(), level.texels.data(), pixels.size() * sizeof pixels[0]);
    return image;
}

std::shared_ptr<ImageTexture const> make_image_texture(TextureData const& data)
{
    auto texture = std::make_shared<ImageTexture>(TRILINEAR, TextureWrapMode(data.wrap_mode));
    for (auto const& level : data.levels)
        TextureAccess::levels(*texture).push_back(make_image(level));
    return texture;
}

/// `evaluate(texture, footprint)` for each footprint.
template <typename Evaluate>
LookUp one_by_one(TextureData const& data, Evaluate const& evaluate)
{
    return [texture = make_image_texture(data), evaluate](Footprint const* footprints, std::size_t count,
                                                          glm::vec4* colours) {
        for (std::size_t i = 0; i < count; ++i)
            colours[i] = evaluate(*texture, footprints[i]);
    };
}
}  // namespace

LookUp prepare_reference_nearest(TextureData const& texture)
{
    return one_by_one(texture, [](ImageTexture const& t, Footprint const& f) { return t.evaluate_nearest(0, f.uv); });
}

LookUp prepare_reference_bilinear(TextureData const& texture)
{
    return one_by_one(texture, [](ImageTexture const& t, Footprint const& f) { return t.evaluate_bilinear(0, f.uv); });
}

LookUp prepare_reference_trilinear(TextureData const& texture)
{
    return one_by_one(texture,
                      [](ImageTexture const& t, Footprint const& f) { return t.evaluate_trilinear(f.uv, f.dudv); });
}
}  // namespace testat::bench
