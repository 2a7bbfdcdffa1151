#include <cglib/rt/scenes.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>
#include <stdexcept>

namespace {
using SceneFunction = std::unique_ptr<Scene> (*)(AssetLibrary&);

std::map<std::string, SceneFunction> const& scene_functions()
{
    static std::map<std::string, SceneFunction> const functions = {
        {"plane", &create_plane_scene},         {"sphere", &create_sphere_scene},
        {"goboard", &create_goboard_scene},     {"pooltable", &create_pooltable_scene},
        {"triangles", &create_triangles_scene},
    };
    return functions;
}
}  // namespace

std::vector<std::string> scene_names()
{
    std::vector<std::string> names;
    for (auto const& [name, function] : scene_functions())
        names.push_back(name);
    return names;
}

std::unique_ptr<Scene> create_scene(std::string const& name, AssetLibrary& assets)
{
    auto const found = scene_functions().find(name);
    if (found == scene_functions().end())
        throw std::invalid_argument(
            fmt::format("there is no scene '{}', only: {}", name, fmt::join(scene_names(), ", ")));
    return found->second(assets);
}
