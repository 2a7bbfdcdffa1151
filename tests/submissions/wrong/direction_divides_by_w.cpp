// verdict: {"loses": {"transform_direction": [1, 1]}, "says": {"transform_direction": "wrong"}, "policy": []}
// Divides by the homogeneous coordinate, which is 0.
glm::vec3 transform_direction(glm::mat4 const& transform, glm::vec3 const& d)

{
    glm::vec4 h = transform * glm::vec4(d, 0.f);
    return glm::normalize(glm::vec3(h) / h.w);
}
