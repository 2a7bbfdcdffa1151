#pragma once

#include <cglib/core/image.h>
#include <cglib/rt/texture_modes.h>

#include <glm/glm.hpp>

// Submissions use std::min({...}), std::floor and the like.
#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

/// A colour that depends on texture coordinates.
class Texture {
public:
    virtual ~Texture();

    /// The colour (linear rgba) at uv; dudv is the size of the pixel's footprint in uv space, zero if unknown.
    virtual glm::vec4 evaluate(glm::vec2 const& uv, glm::vec2 const& dudv = glm::vec2(0)) const = 0;

    /// Whether it looks at uv at all.
    virtual bool depends_on_uv() const { return true; }
};

/// The same colour everywhere.
class ConstTexture : public Texture {
public:
    explicit ConstTexture(glm::vec3 const& value);
    ~ConstTexture() override;

    /// rgb is the value, alpha 0.
    glm::vec4 evaluate(glm::vec2 const& uv, glm::vec2 const& dudv = glm::vec2(0)) const override;
    bool depends_on_uv() const override { return false; }

private:
    glm::vec3 value_;
};

/// A picture, filtered: [0, 1]^2 is the whole of it, (0, 0) its lower left corner.
class ImageTexture : public Texture {
public:
    // First, so that vtable and type information live in the framework and not in the submission.
    ~ImageTexture() override;

    /// Loads level 0 as Image::load does, and throws what that throws.
    ImageTexture(std::string const& filename, TextureFilterMode filter_mode, TextureWrapMode wrap_mode,
                 float gamma = 2.f);

    /// Level 0 is a copy of the image.
    ImageTexture(Image const& image, TextureFilterMode filter_mode, TextureWrapMode wrap_mode);

    /// Without any level, to be given one before it is looked up.
    ImageTexture(TextureFilterMode filter_mode, TextureWrapMode wrap_mode);

    /// The colour at uv, filtered by filter_mode: level 0 for NEAREST and BILINEAR, evaluate_trilinear for TRILINEAR
    /// and DEBUG_MIP, 1 for WHITE.
    glm::vec4 evaluate(glm::vec2 const& uv, glm::vec2 const& dudv = glm::vec2(0)) const override;

    /// STUDENT, task a. The texel of a level in which uv lies: (u, v) = (0, 0) is mapped to (s, t) = (0, 0), (1, 1) to
    /// the level's (width, height), and rounded down.
    glm::vec4 evaluate_nearest(int level, glm::vec2 const& uv) const;

    /// STUDENT, task b. The number in [0, size) nearest to val. size >= 1.
    static int wrap_clamp(int val, int size);

    /// STUDENT, task b. The number in [0, size) that differs from val by a multiple of size. size >= 1.
    static int wrap_repeat(int val, int size);

    /// STUDENT, task c. The four texels around uv, interpolated bilinearly. A texel's value belongs to its centre: at
    /// (s, t) = (1.5, 1.5) the result is texel (1, 1).
    glm::vec4 evaluate_bilinear(int level, glm::vec2 const& uv) const;

    /// STUDENT, task d. Appends to mip_levels: each level half as wide and high (at least 1), the mean of the 2 x 2
    /// (or 2 x 1) texels of the one before, down to a single texel. Sizes are powers of two.
    void create_mipmap();

    /// STUDENT, task d. Bilinear in the two levels next to T = log2(S), interpolated with the fraction of T.
    /// S is the larger extent of the footprint dudv, in texels of level 0.
    glm::vec4 evaluate_trilinear(glm::vec2 const& uv, glm::vec2 const& dudv) const;

    /// A texel of a level (asserted to exist). x and y may be outside: they are wrapped by wrap_repeat, wrap_clamp, or
    /// are zeros. In mode DEBUG_MIP the colour of the level (red, green, blue, yellow, magenta, cyan, and again), in
    /// mode WHITE 1. Asserts that wrapped coordinates are inside.
    glm::vec4 get_texel(int level, int x, int y) const;

    /// Writes a texel of a level; level, x and y are asserted to be inside.
    void set_texel(int level, int x, int y, glm::vec4 const& value);

    /// Level 0 is the picture itself.
    std::vector<std::shared_ptr<Image>> const& get_mip_levels() const { return mip_levels; }

    TextureFilterMode filter_mode;
    TextureWrapMode wrap_mode;

private:
    friend struct TextureAccess;

    std::vector<std::shared_ptr<Image>> mip_levels;
};
