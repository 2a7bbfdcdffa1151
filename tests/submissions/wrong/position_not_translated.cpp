// verdict: {"loses": {"transform_position": [1, 1]}, "says": {"transform_position": "wrong"}, "policy": [], "mistake": {"transform_position": "position_not_translated"}}
// Homogeneous coordinate 0: the translation is lost.
glm::vec3 transform_position(glm::mat4 const& transform, glm::vec3 const& p)
{
    return glm::vec3(transform * glm::vec4(p, 0.f));
}
