#include <cglib/rt/asset_library.h>

#include "../core/packed_texels.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <vector>

namespace fs = std::filesystem;

namespace {
char const cache_folder[] = "texels";

/// Empty if there is none.
std::vector<fs::path> files_with_stem(std::string const& directory, std::string const& stem)
{
    std::vector<fs::path> files;
    std::error_code error;
    for (fs::directory_entry const& entry : fs::directory_iterator(directory, error))
        if (entry.path().stem() == stem && !entry.is_directory(error))
            files.push_back(entry.path());
    return files;
}

std::string path_of(std::string const& directory, std::string const& stem)
{
    fs::path const png = fs::path(directory) / (stem + ".png");
    std::error_code error;
    if (fs::exists(png, error))
        return png.string();
    std::vector<fs::path> const files = files_with_stem(directory, stem);
    if (files.empty())
        throw std::runtime_error(fmt::format("there is no texture '{}' in {}", stem, directory));
    return std::min_element(files.begin(), files.end())->string();
}

std::string cache_path(std::string const& directory, std::string const& stem)
{
    return (fs::path(directory) / cache_folder / stem).string();
}
}  // namespace

AssetLibrary::AssetLibrary(std::string directory) : directory_(std::move(directory)) {}

std::shared_ptr<Image> AssetLibrary::load(std::string const& stem, float gamma) const
{
    std::string const path = path_of(directory_, stem);
    if (auto texels = open_texel_cache(cache_path(directory_, stem), path, gamma))
        return std::make_shared<Image>(std::move(texels));
    auto image = std::make_shared<Image>();
    image->load(path, gamma);
    return image;
}

void AssetLibrary::cache_texels(std::string const& stem) const
{
    std::error_code error;
    fs::create_directories(fs::path(directory_) / cache_folder, error);
    write_texel_cache(cache_path(directory_, stem), path_of(directory_, stem));
}
