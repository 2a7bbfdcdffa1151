// verdict: {"loses": {}}
// A sum of three vectors, normalised by inversesqrt.
glm::vec3 transform_direction_to_object_space(glm::vec3 const& d, glm::vec3 const& normal, glm::vec3 const& tangent, glm::vec3 const& bitangent)
{
    glm::vec3 r = glm::mat3(tangent, normal, bitangent) * d;
    return r * glm::inversesqrt(glm::dot(r, r));
}
