#include "create_images.h"

#include <cglib/rt/assignment_images.h>
#include <cglib/rt/renderer.h>
#include <cglib/rt/scenes.h>

#include <fmt/format.h>
#include <oneapi/tbb/task_group.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <vector>

namespace {
float const picture_gamma = 2.2f;
float const miplevel_gamma = 1.f;

using Report = std::function<void(std::string const& name, RenderStats const&)>;

/// Writes pictures while the next ones are rendered.
class Writer {
public:
    explicit Writer(std::string directory) : directory_(std::move(directory)) {}

    ~Writer()
    {
        tasks_.cancel();
        tasks_.wait();
    }

    void write(std::string const& name, std::shared_ptr<Image const> const& image, float gamma)
    {
        std::string const file = (std::filesystem::path(directory_) / (name + ".png")).string();
        tasks_.run([=] { image->save(file, gamma); });
    }

    /// Throws what a picture has thrown.
    void finish() { tasks_.wait(); }

private:
    std::string directory_;
    tbb::task_group tasks_;
};

void make_directory(std::string const& directory)
{
    std::error_code error;
    std::filesystem::create_directories(directory, error);
    if (error)
        throw std::runtime_error(fmt::format("cannot make the folder {}: {}", directory, error.message()));
}

/// In the order of their first pictures.
std::vector<std::string> scenes_in_order()
{
    std::vector<std::string> names;
    for (AssignmentImage const& picture : assignment_images())
        if (std::find(names.begin(), names.end(), picture.scene) == names.end())
            names.push_back(picture.scene);
    return names;
}

/// One scene after the other, so that only one is in memory.
void create_pictures(std::string const& scene_name, AssetLibrary& assets, int threads, Report const& report,
                     Writer& writer)
{
    std::unique_ptr<Scene> const scene = create_scene(scene_name, assets);
    for (AssignmentImage const& picture : assignment_images()) {
        if (picture.scene != scene_name)
            continue;
        auto image = std::make_shared<Image>();
        RenderOptions options;
        options.threads = threads;
        report(picture.name, render_scene(*scene, picture.params, image.get(), options));
        writer.write(picture.name, image, picture_gamma);
    }
}

/// Files may leave levels out, or empty ones behind.
bool has_level(std::vector<std::shared_ptr<Image>> const& levels, int level)
{
    return level < int(levels.size()) && levels[std::size_t(level)] && levels[std::size_t(level)]->getWidth() > 0;
}

void create_miplevels(AssetLibrary& assets, Writer& writer)
{
    ImageTexture texture(*assets.load("checker", miplevel_gamma), NEAREST, REPEAT);
    texture.create_mipmap();
    auto const& levels = texture.get_mip_levels();
    for (int level = 0; level < num_miplevel_images; ++level) {
        std::string const name = miplevel_image_name(level);
        if (has_level(levels, level))
            writer.write(name, levels[std::size_t(level)], miplevel_gamma);
        else
            fmt::print(stderr, "{} is not written: create_mipmap has not made level {}\n", name, level);
    }
}
}  // namespace

void create_images(AssetLibrary& assets, std::string const& output_directory, int threads, Report const& report)
{
    make_directory(output_directory);
    Writer writer(output_directory);
    for (std::string const& scene : scenes_in_order())
        create_pictures(scene, assets, threads, report, writer);
    create_miplevels(assets, writer);
    writer.finish();
}
