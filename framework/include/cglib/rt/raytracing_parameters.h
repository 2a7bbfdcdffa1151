#pragma once

#include <cglib/core/parameters.h>
#include <cglib/rt/epsilon.h>
#include <cglib/rt/texture_modes.h>

/// What a pixel shows.
enum RenderMode {
    /// The shaded scene.
    RECURSIVE,
    /// The shaded scene in grey.
    DESATURATE,
    /// How many rays the pixel took, as heatmap.
    NUM_RAYS,
    /// The normal (after normal mapping if that is on) as colour.
    NORMAL,
    /// How long the pixel took, as heatmap.
    TIME,
    /// The size of the footprint in uv space, as heatmap.
    DUDV,
    RENDER_MODE_COUNT
};

/// How a picture is rendered.
struct RaytracingParameters : public Parameters {
    /// Reflected and transmitted rays are followed while their depth is at most this.
    int max_depth = 4;

    bool shadows = true;
    bool ambient = true;
    bool diffuse = true;
    bool specular = true;
    bool reflection = true;
    bool transmission = true;
    bool fresnel = true;

    /// In world units.
    float ray_epsilon = default_ray_epsilon;
    /// In degrees; see Camera::direction for what it means.
    float fovy = 45.f;

    /// Samples in each pixel, >= 1.
    int spp = 1;
    /// Samples are spread over a grid instead of anywhere in the pixel.
    bool stratified = false;

    bool normal_mapping = false;
    /// Off, objects stand in the world as if their matrices were identities.
    bool transform_objects = true;

    TextureFilterMode tex_filter_mode = NEAREST;
    TextureWrapMode tex_wrap_mode = REPEAT;
    RenderMode render_mode = RECURSIVE;
};
