// verdict: {"loses": {"transform_direction": [0.5, 0.5]}, "says": {"transform_direction": "partial"}, "policy": [], "mistake": {"transform_direction": "direction_is_translated"}}
// Homogeneous coordinate 1: the translation is added.
glm::vec3 transform_direction(glm::mat4 const& transform, glm::vec3 const& d)
{
    return glm::normalize(glm::vec3(transform * glm::vec4(d, 1.f)));
}
