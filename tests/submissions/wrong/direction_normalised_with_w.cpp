// verdict: {"loses": {"transform_direction": [1, 1]}, "says": {"transform_direction": "wrong"}, "policy": []}
// Homogeneous coordinate 1, and all four components are normalised.
glm::vec3 transform_direction(glm::mat4 const& transform, glm::vec3 const& d)

{
    return glm::vec3(glm::normalize(transform * glm::vec4(d, 1.f)));
}
