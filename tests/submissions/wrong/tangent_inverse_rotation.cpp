// verdict: {"loses": {"transform_direction_to_object_space": [2, 2]}, "says": {"transform_direction_to_object_space": "wrong"}, "policy": [], "mistake": {"transform_direction_to_object_space": "tangent_inverse_rotation"}}
// From object space to tangent space.
glm::vec3 transform_direction_to_object_space(glm::vec3 const& d, glm::vec3 const& normal, glm::vec3 const& tangent,
                                              glm::vec3 const& bitangent)
{
    return glm::normalize(glm::transpose(glm::mat3(tangent, normal, bitangent)) * d);
}
