// verdict: {"loses": {"transform_position": [0.5, 0.5]}, "says": {"transform_position": "partial"}, "policy": []}
// Columns are normalised "to get the rotation": right as long as nothing is scaled.
glm::vec3 transform_position(glm::mat4 const& transform, glm::vec3 const& p)

{
    glm::vec3 x = glm::normalize(glm::vec3(transform[0]));
    glm::vec3 y = glm::normalize(glm::vec3(transform[1]));
    glm::vec3 z = glm::normalize(glm::vec3(transform[2]));
    return p.x * x + p.y * y + p.z * z + glm::vec3(transform[3]);
}
