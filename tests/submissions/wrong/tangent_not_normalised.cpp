// verdict: {"loses": {"transform_direction_to_object_space": [0.5, 0.5]}, "says": {"transform_direction_to_object_space": "partial"}, "policy": [], "mistake": {"transform_direction_to_object_space": "tangent_not_normalised"}}
// The result is not normalised.
glm::vec3 transform_direction_to_object_space(glm::vec3 const& d, glm::vec3 const& normal, glm::vec3 const& tangent,
                                              glm::vec3 const& bitangent)
{
    return glm::mat3(tangent, normal, bitangent) * d;
}
