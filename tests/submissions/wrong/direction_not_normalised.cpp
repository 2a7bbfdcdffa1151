// verdict: {"loses": {"transform_direction": [0.5, 0.5]}, "says": {"transform_direction": "partial"}, "policy": [], "mistake": {"transform_direction": "direction_not_normalised"}}
// The result is not normalised.
glm::vec3 transform_direction(glm::mat4 const& transform, glm::vec3 const& d)
{
    return glm::vec3(transform * glm::vec4(d, 0.f));
}
