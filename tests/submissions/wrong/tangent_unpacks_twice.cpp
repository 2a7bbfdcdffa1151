// verdict: {"loses": {"transform_direction_to_object_space": [2, 2]}, "says": {"transform_direction_to_object_space": "wrong"}, "policy": []}
// Maps [0, 1] to [-1, 1], which the caller has done already.
glm::vec3 transform_direction_to_object_space(glm::vec3 const& d, glm::vec3 const& normal, glm::vec3 const& tangent,
                                              glm::vec3 const& bitangent)

{
    glm::vec3 n = 2.f * d - 1.f;
    return glm::normalize(n.x * tangent + n.y * normal + n.z * bitangent);
}
