#pragma once

#include <cglib/rt/asset_library.h>
#include <cglib/rt/scene.h>

#include <memory>
#include <string>
#include <vector>

/// The names that create_scene knows.
std::vector<std::string> scene_names();

/// Throws std::invalid_argument listing the names if there is none of this name, std::runtime_error if a texture is
/// missing. Textures have level 0 only.
std::unique_ptr<Scene> create_scene(std::string const& name, AssetLibrary& assets);

/// A textured plane that reaches to the horizon: how textures alias.
std::unique_ptr<Scene> create_plane_scene(AssetLibrary& assets);
