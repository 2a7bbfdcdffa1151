#pragma once

#include <cglib/core/camera.h>
#include <cglib/rt/light.h>
#include <cglib/rt/object.h>
#include <cglib/rt/texture.h>

#include <memory>
#include <vector>

/// Everything that is rendered.
struct Scene {
    std::vector<std::shared_ptr<Object>> objects;
    std::vector<Light> lights;
    Camera camera;
    /// Every image texture that a material of the scene uses, once.
    std::vector<std::shared_ptr<ImageTexture>> textures;
};
