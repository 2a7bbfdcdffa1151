#pragma once

#include <cglib/rt/asset_library.h>
#include <cglib/rt/scene.h>

#include <memory>
#include <string>

/// What a picture file holds, and so the gamma it is decoded with.
enum class Holds { diffuse, normals, environment };

/// Adds the picture of this stem to the scene's textures and returns its texture. It is loaded when it is first needed;
/// assets must live until then.
std::shared_ptr<ImageTexture> add_texture(Scene& scene, AssetLibrary& assets, std::string const& stem, Holds holds);
