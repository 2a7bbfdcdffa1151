#pragma once

#include <cglib/rt/asset_library.h>
#include <cglib/rt/scene.h>

#include <memory>
#include <string>
#include <vector>

/// The names that create_scene knows.
std::vector<std::string> scene_names();

/// Throws std::invalid_argument listing the names if there is none of this name. Textures are loaded when a picture
/// first needs them; assets must live as long as the scene.
std::unique_ptr<Scene> create_scene(std::string const& name, AssetLibrary& assets);

/// A textured plane that reaches to the horizon: how textures alias.
std::unique_ptr<Scene> create_plane_scene(AssetLibrary& assets);

/// A ball of stone on a floor of concrete, with normal maps.
std::unique_ptr<Scene> create_sphere_scene(AssetLibrary& assets);

/// A Go board with 82 stones: spheres that transforms have flattened.
std::unique_ptr<Scene> create_goboard_scene(AssetLibrary& assets);

/// 15 balls on a pool table, each turned at random. Without transforms all of them are at the origin.
std::unique_ptr<Scene> create_pooltable_scene(AssetLibrary& assets);

/// Not on the sheet: a mesh of triangles, and a ball of glass.
std::unique_ptr<Scene> create_triangles_scene(AssetLibrary& assets);
