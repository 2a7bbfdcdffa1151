#pragma once

#include <cglib/rt/asset_library.h>
#include <cglib/rt/scene.h>

#include <memory>
#include <string>

/// Adds the picture of this stem to the scene's textures as a diffuse map (gamma 2.2) and returns it.
std::shared_ptr<ImageTexture> add_diffuse_texture(Scene& scene, AssetLibrary& assets, std::string const& stem);
