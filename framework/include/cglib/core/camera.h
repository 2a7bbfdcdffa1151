#pragma once

#include <glm/glm.hpp>

/// A pinhole camera in right-handed world space. It looks along -z of its own space, y is up.
class Camera {
public:
    /// At the origin, looking along -z.
    Camera() = default;

    /// direction and up need not be unit, and must not be parallel.
    static Camera looking_along(glm::vec3 const& position, glm::vec3 const& direction,
                                glm::vec3 const& up = glm::vec3(0.f, 1.f, 0.f));

    /// Like looking_along, towards a point that is not the position itself.
    static Camera looking_at(glm::vec3 const& position, glm::vec3 const& target,
                             glm::vec3 const& up = glm::vec3(0.f, 1.f, 0.f));

    /// Where all rays start, in world space.
    glm::vec3 const& position() const { return position_; }

    /// Unit, in world space: where the centre of the picture looks, what is right in it and what is up.
    glm::vec3 forward() const { return -camera_to_world_[2]; }
    /// Like forward.
    glm::vec3 right() const { return camera_to_world_[0]; }
    /// Like forward.
    glm::vec3 up() const { return camera_to_world_[1]; }

    /// The direction (not unit, world space) to the image position (x, y) in pixels, (0, 0) being the lower left corner
    /// of the picture and (0.5, 0.5) the centre of its first pixel: (x - w/2, y - h/2, -h/tan(fovy)) in camera space.
    /// Mind that a picture is h high at the distance h/tan(fovy): fovy = 45 degrees is a vertical field of view
    /// of 53.13.
    glm::vec3 direction(glm::vec2 const& pixel, int width, int height, float fovy_degrees) const;

private:
    glm::vec3 position_ = glm::vec3(0.f, 0.f, 0.f);
    /// Columns: right, up and backward in world space, orthonormal.
    glm::mat3 camera_to_world_ = glm::mat3(1.f);
};
