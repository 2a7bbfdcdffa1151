#pragma once

#include <cglib/core/image.h>

#include <map>
#include <memory>
#include <mutex>
#include <string>

struct TexelBytes;

/// The textures of one folder. Safe for several threads.
class AssetLibrary {
public:
    /// The folder is not read yet.
    explicit AssetLibrary(std::string directory);
    ~AssetLibrary();

    /// The picture STEM.png, or else STEM with another extension (the alphabetically first that can be read), as
    /// Image::load gives it with this gamma; the caller's own. A PNG of 8 bit is decoded once in the library's life,
    /// and not at all where the folder holds its texels (see cache_texels). Throws std::runtime_error naming stem and
    /// directory if there is none.
    std::shared_ptr<Image> load(std::string const& stem, float gamma);

    /// Decodes STEM.png, which has 8 bit for each channel, and keeps its texels beside it. They are no longer used once
    /// the picture's file has changed. Throws std::runtime_error naming what is missing or cannot be written.
    void cache_texels(std::string const& stem) const;

    /// Maps all that cache_texels has kept into memory: from then on load() opens no file for these pictures.
    void map_texels();

private:
    std::shared_ptr<TexelBytes const> texels_of(std::string const& stem);

    std::string directory_;
    std::mutex mutex_;
    /// By stem, what has been asked for of 8-bit PNGs.
    std::map<std::string, std::shared_ptr<TexelBytes const>> texels_;
};
