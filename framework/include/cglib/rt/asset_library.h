#pragma once

#include <cglib/core/image.h>

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

/// The textures of one folder, each decoded when it is first asked for. Safe for several threads.
class AssetLibrary {
public:
    /// The folder is not read yet.
    explicit AssetLibrary(std::string directory);

    /// The picture STEM.png, or else STEM with another extension (the alphabetically first), loaded with this gamma.
    /// Decoded once and shared. Throws std::runtime_error naming stem and directory if there is none.
    std::shared_ptr<Image const> find(std::string const& stem, float gamma);

private:
    std::string directory_;
    std::mutex mutex_;
    std::map<std::pair<std::string, float>, std::shared_ptr<Image const>> images_;
};
