#include "scene_textures.h"

namespace {
float gamma_of(Holds holds)
{
    switch (holds) {
        case Holds::normals:
            return 1.f;
        case Holds::environment:
            return 2.f;
        default:
            return 2.2f;
    }
}
}  // namespace

std::shared_ptr<ImageTexture> add_texture(Scene& scene, AssetLibrary& assets, std::string const& stem, Holds holds)
{
    auto texture = std::make_shared<ImageTexture>(NEAREST, REPEAT);
    scene.textures.push_back({texture, [&assets, stem, holds] { return assets.load(stem, gamma_of(holds)); }});
    return texture;
}
