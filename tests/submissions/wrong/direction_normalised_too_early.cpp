// verdict: {"loses": {"transform_direction": [0.5, 0.5]}, "says": {"transform_direction": "partial"}, "policy": []}
// Normalises before the matrix instead of behind it.
glm::vec3 transform_direction(glm::mat4 const& transform, glm::vec3 const& d)

{
    glm::vec3 unit = glm::normalize(d);
    return glm::vec3(transform * glm::vec4(unit, 0.f));
}
