#include <cglib/rt/asset_library.h>

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <vector>

namespace fs = std::filesystem;

namespace {
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
}  // namespace

AssetLibrary::AssetLibrary(std::string directory) : directory_(std::move(directory)) {}

std::shared_ptr<Image const> AssetLibrary::find(std::string const& stem, float gamma)
{
    std::lock_guard<std::mutex> const lock(mutex_);
    std::shared_ptr<Image const>& image = images_[{stem, gamma}];
    if (!image) {
        auto loaded = std::make_shared<Image>();
        loaded->load(path_of(directory_, stem), gamma);
        image = loaded;
    }
    return image;
}
