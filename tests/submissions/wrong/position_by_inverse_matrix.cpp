// verdict: {"loses": {"transform_position": [1, 1]}, "says": {"transform_position": "wrong"}, "policy": [], "mistake": {"transform_position": "position_by_inverse_matrix"}}
// The way back.
glm::vec3 transform_position(glm::mat4 const& transform, glm::vec3 const& p)

{
    return glm::vec3(glm::inverse(transform) * glm::vec4(p, 1.f));
}
