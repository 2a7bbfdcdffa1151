// verdict: {"loses": {}}
// Division by w; a direction by the upper left 3 x 3 matrix; axes added up.
glm::vec3 transform_direction(glm::mat4 const& transform, glm::vec3 const& d)
{
    return glm::normalize(glm::mat3(transform) * d);
}

glm::vec3 transform_position(glm::mat4 const& transform, glm::vec3 const& p)
{
    glm::vec4 const q = transform * glm::vec4(p.x, p.y, p.z, 1);
    return glm::vec3(q) / q.w;
}

glm::vec3 transform_direction_to_object_space(glm::vec3 const& d, glm::vec3 const& normal, glm::vec3 const& tangent,
                                              glm::vec3 const& bitangent)
{
    glm::vec3 const sum = d.x * tangent + d.y * normal + d.z * bitangent;
    return sum / glm::length(sum);
}
