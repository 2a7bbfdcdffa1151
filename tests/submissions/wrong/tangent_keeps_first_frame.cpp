// verdict: {"loses": {"transform_direction_to_object_space": [2, 2]}, "says": {"transform_direction_to_object_space": "wrong"}, "policy": [], "remarks": ["depends_on_earlier_calls"]}
// State between calls: the matrix of the first call is used for all.
glm::vec3 transform_direction_to_object_space(glm::vec3 const& d, glm::vec3 const& normal, glm::vec3 const& tangent,
                                              glm::vec3 const& bitangent)
{
    static glm::mat3 const to_object(tangent, normal, bitangent);
    return glm::normalize(to_object * d);
}
