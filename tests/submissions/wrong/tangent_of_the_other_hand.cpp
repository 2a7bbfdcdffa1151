// verdict: {"loses": {"transform_direction_to_object_space": [2, 2]}, "says": {"transform_direction_to_object_space": "wrong"}, "policy": []}
// Builds a bitangent of its own, of the opposite sign.
glm::vec3 transform_direction_to_object_space(glm::vec3 const& d, glm::vec3 const& normal, glm::vec3 const& tangent,
                                              glm::vec3 const& bitangent)

{
    (void)bitangent;
    glm::vec3 b = glm::cross(normal, tangent);
    return glm::normalize(d.x * tangent + d.y * normal + d.z * b);
}
