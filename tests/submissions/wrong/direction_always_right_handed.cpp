// verdict: {"loses": {"transform_direction": [0.5, 0.5]}, "says": {"transform_direction": "partial"}, "policy": []}
// Turns around where the matrix mirrors.
glm::vec3 transform_direction(glm::mat4 const& transform, glm::vec3 const& d)

{
    glm::mat3 linear(transform);
    float sign = glm::determinant(linear) < 0.f ? -1.f : 1.f;
    return glm::normalize(sign * (linear * d));
}
