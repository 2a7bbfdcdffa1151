#pragma once

#include <cglib/rt/texture.h>

#include <memory>
#include <vector>

/// The framework's and the grader's door to a texture's mip levels. Exercises do not need it.
struct TextureAccess {
    static std::vector<std::shared_ptr<Image>>& levels(ImageTexture& texture) { return texture.mip_levels; }
};
