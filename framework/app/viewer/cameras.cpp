#include "cameras.h"

#include <algorithm>
#include <cmath>

namespace viewer {
namespace {
float const radians_per_picture_height = 3.f;
/// Straight up or down there is no telling what is right.
float const steepest = glm::radians(89.f);
float const least_distance = 1e-3f;

/// Turned right and up, by angles in radians.
glm::vec3 turned(glm::vec3 const& direction, glm::vec2 const& angles)
{
    float const yaw = std::atan2(direction.x, -direction.z) + angles.x;
    float const pitch = std::clamp(std::asin(std::clamp(direction.y, -1.f, 1.f)) + angles.y, -steepest, steepest);
    return glm::vec3(std::sin(yaw) * std::cos(pitch), std::sin(pitch), -std::cos(yaw) * std::cos(pitch));
}

glm::vec3 target_of(View const& view)
{
    return view.camera.position() + view.distance * view.camera.forward();
}

View shifted(View const& view, glm::vec3 const& offset)
{
    Camera const& camera = view.camera;
    return {Camera::looking_along(camera.position() + offset, camera.forward()), view.distance};
}

View looking_at_target(glm::vec3 const& target, glm::vec3 const& direction, float distance)
{
    return {Camera::looking_along(target - distance * direction, direction), distance};
}
}  // namespace

View initial_view(Camera const& camera)
{
    glm::vec3 const& position = camera.position();
    glm::vec3 const forward = camera.forward();
    float const to_ground = -position.y / forward.y;
    // Comparisons are false for an infinite distance and for none at all.
    float const distance = to_ground > 0.f && to_ground < 1e6f ? to_ground : std::abs(glm::dot(position, forward));
    return {camera, std::max(distance, least_distance)};
}

View orbit(View const& view, CameraInput const& input)
{
    View next = view;
    if (input.left_drag != glm::vec2(0.f))
        next = looking_at_target(target_of(next),
                                 turned(next.camera.forward(), radians_per_picture_height * input.left_drag),
                                 next.distance);
    if (input.wheel != 0.f || input.right_drag.y != 0.f) {
        float const nearer = std::exp(-0.1f * input.wheel - 2.f * input.right_drag.y);
        next =
            looking_at_target(target_of(next), next.camera.forward(), std::max(next.distance * nearer, least_distance));
    }
    if (input.middle_drag != glm::vec2(0.f)) {
        glm::vec2 const drag = next.distance * input.middle_drag;
        next = shifted(next, -drag.x * next.camera.right() - drag.y * next.camera.up());
    }
    return next;
}

View fly(View const& view, CameraInput const& input)
{
    View next = view;
    glm::vec2 const drag = input.left_drag + input.middle_drag + input.right_drag;
    if (drag != glm::vec2(0.f))
        next.camera = Camera::looking_along(next.camera.position(),
                                            turned(next.camera.forward(), radians_per_picture_height * drag));
    glm::vec3 const steps = 0.5f * next.distance * (input.walked + glm::vec3(0.f, 0.f, 0.2f * input.wheel));
    if (steps != glm::vec3(0.f))
        next = shifted(next,
                       steps.x * next.camera.right() + glm::vec3(0.f, steps.y, 0.f) + steps.z * next.camera.forward());
    return next;
}

}  // namespace viewer
