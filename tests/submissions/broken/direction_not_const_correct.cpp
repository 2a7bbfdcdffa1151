// verdict: {"broken": {"transform_direction": "d = glm::vec3(transform"}, "unofficial": [19, 19]}
// The parameter is not the function's to change.
glm::vec3 transform_direction(glm::mat4 const& transform, glm::vec3 const& d)
{
    d = glm::vec3(transform * glm::vec4(d, 0.f));
    return glm::normalize(d);
}
