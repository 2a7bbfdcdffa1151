// verdict: {"broken": {"transform_position": 0}, "unofficial": [19, 19]}
// Compiles, as an overload; what the framework calls is missing.
glm::vec3 transform_position(glm::mat4 const& transform, glm::vec4 const& p)
{
    return glm::vec3(transform * p);
}
