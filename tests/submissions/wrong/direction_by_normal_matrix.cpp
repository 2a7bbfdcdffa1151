// verdict: {"loses": {"transform_direction": [0.5, 0.5]}, "says": {"transform_direction": "partial"}, "policy": [], "mistake": {"transform_direction": "direction_as_normal"}}
// The matrix for normals: right as long as nothing is scaled.
glm::vec3 transform_direction(glm::mat4 const& transform, glm::vec3 const& d)

{
    glm::mat3 normal_matrix = glm::transpose(glm::inverse(glm::mat3(transform)));
    return glm::normalize(normal_matrix * d);
}
