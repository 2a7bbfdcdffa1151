#include "image_textures.h"

namespace {
float const diffuse_gamma = 2.2f;
}

std::shared_ptr<ImageTexture> add_diffuse_texture(Scene& scene, AssetLibrary& assets, std::string const& stem)
{
    scene.textures.push_back(std::make_shared<ImageTexture>(*assets.find(stem, diffuse_gamma), NEAREST, REPEAT));
    return scene.textures.back();
}
