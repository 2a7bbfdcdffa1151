// verdict: {"loses": {"transform_direction_to_object_space": [1, 1]}, "says": {"transform_direction_to_object_space": "partial"}, "policy": []}
// Ignores the bitangent it is given: right for right-handed frames only.
glm::vec3 transform_direction_to_object_space(glm::vec3 const& d, glm::vec3 const& normal, glm::vec3 const& tangent,
                                              glm::vec3 const& bitangent)

{
    (void)bitangent;
    return glm::normalize(glm::mat3(tangent, normal, glm::cross(tangent, normal)) * d);
}
