// verdict: {"loses": {"transform_position": [1, 1]}, "says": {"transform_position": "wrong"}, "policy": [], "mistake": {"transform_position": "position_normalised"}}
// The position is normalised like a direction.
glm::vec3 transform_position(glm::mat4 const& transform, glm::vec3 const& p)
{
    return glm::normalize(glm::vec3(transform * glm::vec4(p, 1.f)));
}
