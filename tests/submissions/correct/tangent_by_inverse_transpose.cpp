// verdict: {"loses": {}}
// Of a rotation, that is the rotation.
glm::vec3 transform_direction_to_object_space(glm::vec3 const& d, glm::vec3 const& normal, glm::vec3 const& tangent, glm::vec3 const& bitangent)
{
    glm::mat3 rot = glm::inverse(glm::transpose(glm::mat3(tangent, normal, bitangent)));
    return glm::normalize(rot * d);
}
