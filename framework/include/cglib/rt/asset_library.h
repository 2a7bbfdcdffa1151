#pragma once

#include <cglib/core/image.h>

#include <memory>
#include <string>

/// The textures of one folder. Safe for several threads.
class AssetLibrary {
public:
    /// The folder is not read yet.
    explicit AssetLibrary(std::string directory);

    /// The picture STEM.png, or else STEM with another extension (the alphabetically first), as Image::load gives it
    /// with this gamma; the caller's own. Where the folder holds its decoded texels (see cache_texels), they are mapped
    /// into memory instead, which takes no time. Throws std::runtime_error naming stem and directory if there is none.
    std::shared_ptr<Image> load(std::string const& stem, float gamma) const;

    /// Decodes STEM.png, which has 8 bit for each channel, and keeps its texels beside it. They are no longer used once
    /// the picture's file has changed. Throws std::runtime_error naming what is missing or cannot be written.
    void cache_texels(std::string const& stem) const;

private:
    std::string directory_;
};
