#pragma once

/// How a texture is filtered.
enum TextureFilterMode {
    /// The texel that uv lies in.
    NEAREST,
    /// Between four texels.
    BILINEAR,
    /// Between four texels in each of two mip levels.
    TRILINEAR,
    /// Trilinear, each mip level having one colour instead of its texels.
    DEBUG_MIP,
    /// All textures are white.
    WHITE,
    TEXTURE_FILTER_MODE_COUNT
};

/// What lies outside of a texture.
enum TextureWrapMode {
    /// The texture again.
    REPEAT,
    /// The texels of its border.
    CLAMP,
    /// Zeros.
    ZERO,
    TEXTURE_WRAP_MODE_COUNT
};

/// For people, indexed by TextureFilterMode.
extern const char* tex_filter_mode_names[];

/// For people, indexed by TextureWrapMode.
extern const char* tex_wrap_mode_names[];
