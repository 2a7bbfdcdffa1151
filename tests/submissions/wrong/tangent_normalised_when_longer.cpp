// verdict: {"loses": {"transform_direction_to_object_space": [0.5, 0.5]}, "says": {"transform_direction_to_object_space": "partial"}, "policy": []}
// Normalises only what is longer than 1.
glm::vec3 transform_direction_to_object_space(glm::vec3 const& d, glm::vec3 const& normal, glm::vec3 const& tangent,
                                              glm::vec3 const& bitangent)

{
    glm::vec3 r = glm::mat3(tangent, normal, bitangent) * d;
    float l = glm::length(r);
    return l > 1.f ? r / l : r;
}
