// verdict: {"loses": {"transform_direction": [0.5, 0.5]}, "says": {"transform_direction": "partial"}, "policy": [], "mistake": {"transform_direction": "direction_as_normal"}}
// The matrix for normals, by cross products of the columns: right as long as nothing is scaled.
glm::vec3 transform_direction(glm::mat4 const& transform, glm::vec3 const& d)
{
    glm::vec3 a(transform[0]);
    glm::vec3 b(transform[1]);
    glm::vec3 c(transform[2]);
    return glm::normalize(d.x * glm::cross(b, c) + d.y * glm::cross(c, a) + d.z * glm::cross(a, b));
}
