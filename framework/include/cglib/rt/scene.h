#pragma once

#include <cglib/core/camera.h>
#include <cglib/rt/light.h>
#include <cglib/rt/object.h>
#include <cglib/rt/texture.h>

#include <functional>
#include <memory>
#include <vector>

/// An image texture of a scene, and how it gets its picture.
struct SceneTexture {
    /// Without any level until it is loaded.
    std::shared_ptr<ImageTexture> texture;
    /// Gives level 0, when a picture first needs the texture; throws std::runtime_error if it cannot. May be empty for
    /// a texture that has its levels already.
    std::function<std::shared_ptr<Image>()> load;
};

/// Everything that is rendered.
struct Scene {
    std::vector<std::shared_ptr<Object>> objects;
    std::vector<Light> lights;
    Camera camera;
    /// Every image texture of materials and environment, once.
    std::vector<SceneTexture> textures;
    /// What rays see that hit nothing: all directions as longitude and latitude. May be null: then it is black.
    std::shared_ptr<ImageTexture> environment;
};
