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

std::string png_path(std::string const& directory, std::string const& stem)
{
    return (fs::path(directory) / (stem + ".png")).string();
}

std::string cache_path(std::string const& directory, std::string const& stem)
{
    return (fs::path(directory) / cache_folder / stem).string();
}

/// The first of the files that can be read. Beside a picture there may be a text of the same name.
std::shared_ptr<Image> load_first(std::vector<fs::path> files, float gamma)
{
    std::sort(files.begin(), files.end());
    std::string problem;
    for (fs::path const& file : files) {
        try {
            auto image = std::make_shared<Image>();
            image->load(file.string(), gamma);
            return image;
        } catch (std::runtime_error const& error) {
            if (problem.empty())
                problem = error.what();
        }
    }
    throw std::runtime_error(problem);
}
}  // namespace

AssetLibrary::AssetLibrary(std::string directory) : directory_(std::move(directory)) {}

AssetLibrary::~AssetLibrary() = default;

std::shared_ptr<Image> AssetLibrary::load(std::string const& stem, float gamma)
{
    if (auto const texels = texels_of(stem))
        return std::make_shared<Image>(std::make_shared<PackedTexels>(texels, gamma));
    std::error_code error;
    std::string const png = png_path(directory_, stem);
    std::vector<fs::path> files{png};
    if (!fs::exists(png, error))
        files = files_with_stem(directory_, stem);
    if (files.empty())
        throw std::runtime_error(fmt::format("there is no texture '{}' in {}", stem, directory_));
    return load_first(files, gamma);
}

/// Null if there is no PNG of 8 bit.
std::shared_ptr<TexelBytes const> AssetLibrary::texels_of(std::string const& stem)
{
    std::lock_guard<std::mutex> const lock(mutex_);
    std::shared_ptr<TexelBytes const>& texels = texels_[stem];
    std::error_code error;
    std::string const png = png_path(directory_, stem);
    if (!texels && fs::exists(png, error)) {
        texels = open_texel_cache(cache_path(directory_, stem), png);
        if (!texels)
            texels = decode_texels(png);
    }
    return texels;
}

void AssetLibrary::map_texels()
{
    std::error_code error;
    std::lock_guard<std::mutex> const lock(mutex_);
    for (fs::directory_entry const& entry : fs::directory_iterator(fs::path(directory_) / cache_folder, error)) {
        std::string const stem = entry.path().filename().string();
        if (auto texels = open_texel_cache(entry.path().string(), png_path(directory_, stem)))
            texels_[stem] = std::move(texels);
    }
}

void AssetLibrary::cache_texels(std::string const& stem) const
{
    std::string const png = png_path(directory_, stem);
    if (!fs::exists(png))
        throw std::runtime_error(fmt::format("there is no texture '{}' in {}", stem, directory_));
    std::error_code error;
    fs::create_directories(fs::path(directory_) / cache_folder, error);
    write_texel_cache(cache_path(directory_, stem), png);
}
