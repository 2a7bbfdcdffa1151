// verdict: {"loses": {}}
// Where d ends less where it begins.
glm::vec3 transform_direction(glm::mat4 const& transform, glm::vec3 const& d)
{
    return glm::normalize(transform_position(transform, d) - transform_position(transform, glm::vec3(0)));
}
