#pragma once

#include <cglib/core/camera.h>

#include <glm/glm.hpp>

namespace viewer {

/// Where one looks from.
struct View {
    Camera camera;
    /// From the camera to the point that it orbits, straight ahead; the scale of all movements. In world units, > 0.
    float distance = 1.f;
};

/// What mouse and keys did since the last frame. Without any of it a view stays the very same.
struct CameraInput {
    /// Of the mouse with its button held, right and up, 1 being the height of the picture.
    glm::vec2 left_drag = glm::vec2(0.f), middle_drag = glm::vec2(0.f), right_drag = glm::vec2(0.f);
    /// Steps of the wheel, away from the user.
    float wheel = 0.f;
    /// Seconds that keys were held for going right, up and forward, less those for the opposite.
    glm::vec3 walked = glm::vec3(0.f);
};

/// Looks as the scene's camera does, at the ground (y = 0) straight ahead; where there is none, at what is nearest to
/// the origin.
View initial_view(Camera const& camera);

/// Left drag turns the view around its target as if one dragged the scene, wheel and right drag change the distance,
/// middle drag shifts camera and target.
View orbit(View const& view, CameraInput const& input);

/// Keys move the camera, drags turn it where it is, the wheel moves it forward.
View fly(View const& view, CameraInput const& input);

}  // namespace viewer
