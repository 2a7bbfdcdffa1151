#include <cglib/core/camera.h>

#include <cmath>

Camera Camera::looking_along(glm::vec3 const& position, glm::vec3 const& direction, glm::vec3 const& up)
{
    glm::vec3 const backward = -glm::normalize(direction);
    glm::vec3 const right = glm::normalize(glm::cross(up, backward));
    Camera camera;
    camera.position_ = position;
    camera.camera_to_world_ = glm::mat3(right, glm::cross(backward, right), backward);
    return camera;
}

Camera Camera::looking_at(glm::vec3 const& position, glm::vec3 const& target, glm::vec3 const& up)
{
    return looking_along(position, target - position, up);
}

glm::vec3 Camera::direction(glm::vec2 const& pixel, int width, int height, float fovy_degrees) const
{
    float const w = float(width);
    float const h = float(height);
    float const distance = h / std::tan(glm::radians(fovy_degrees));
    return camera_to_world_ * glm::vec3(pixel.x - 0.5f * w, pixel.y - 0.5f * h, -distance);
}
