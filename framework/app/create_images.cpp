#include "create_images.h"

#include <cglib/rt/assignment_images.h>
#include <cglib/rt/renderer.h>
#include <cglib/rt/scenes.h>

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <map>
#include <stdexcept>

namespace {
using Levels = std::vector<std::shared_ptr<Image>>;

float const picture_gamma = 2.2f;
float const miplevel_gamma = 1.f;

/// Each scene is made once.
class Scenes {
public:
    explicit Scenes(AssetLibrary& assets) : assets_(assets) {}

    Scene& get(std::string const& name)
    {
        std::unique_ptr<Scene>& scene = scenes_[name];
        if (!scene)
            scene = create_scene(name, assets_);
        return *scene;
    }

private:
    AssetLibrary& assets_;
    std::map<std::string, std::unique_ptr<Scene>> scenes_;
};

std::string file_name(std::string const& directory, std::string const& name)
{
    return (std::filesystem::path(directory) / (name + ".png")).string();
}

void make_directory(std::string const& directory)
{
    std::error_code error;
    std::filesystem::create_directories(directory, error);
    if (error)
        throw std::runtime_error(fmt::format("cannot make the folder {}: {}", directory, error.message()));
}

void create_pictures(AssetLibrary& assets, std::string const& directory)
{
    Scenes scenes(assets);
    Image image;
    for (AssignmentImage const& picture : assignment_images()) {
        render_scene(scenes.get(picture.scene), picture.params, &image);
        image.save(file_name(directory, picture.name), picture_gamma);
    }
}

/// Files may leave levels out, or empty ones behind.
bool has_level(Levels const& levels, int level)
{
    return level < int(levels.size()) && levels[level] && !levels[level]->getPixels().empty();
}

void create_miplevels(AssetLibrary& assets, std::string const& directory)
{
    ImageTexture texture(*assets.find("checker", miplevel_gamma), NEAREST, REPEAT);
    texture.create_mipmap();
    Levels const& levels = texture.get_mip_levels();
    for (int level = 0; level < num_miplevel_images; ++level) {
        std::string const name = miplevel_image_name(level);
        if (has_level(levels, level))
            levels[level]->save(file_name(directory, name), miplevel_gamma);
        else
            fmt::print(stderr, "{} is not written: create_mipmap has not made level {}\n", name, level);
    }
}
}  // namespace

void create_images(std::string const& assets_directory, std::string const& output_directory)
{
    make_directory(output_directory);
    AssetLibrary assets(assets_directory);
    create_pictures(assets, output_directory);
    create_miplevels(assets, output_directory);
}
