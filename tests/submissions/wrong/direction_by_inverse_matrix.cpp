// verdict: {"loses": {"transform_direction": [1, 1]}, "says": {"transform_direction": "wrong"}, "policy": [], "mistake": {"transform_direction": "direction_by_inverse_matrix"}}
// Transforms into the other direction.
glm::vec3 transform_direction(glm::mat4 const& transform, glm::vec3 const& d)

{
    return glm::normalize(glm::vec3(glm::inverse(transform) * glm::vec4(d, 0.f)));
}
