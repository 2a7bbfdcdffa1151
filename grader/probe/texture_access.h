#pragma once
#include <cglib/rt/texture.h>

#include <memory>
#include <vector>

/// The framework's door for us to a texture's mip levels.
struct TextureAccess {
    static std::vector<std::shared_ptr<Image>>& levels(ImageTexture& texture) { return texture.mip_levels; }
};
