// verdict: {"loses": {}}
// Component by component, in double.
static double row(glm::mat4 const& m, int i, glm::vec3 const& v, double w)
{
    return double(m[0][i]) * v.x + double(m[1][i]) * v.y + double(m[2][i]) * v.z + double(m[3][i]) * w;
}

glm::vec3 transform_direction(glm::mat4 const& transform, glm::vec3 const& d)
{
    double x = row(transform, 0, d, 0), y = row(transform, 1, d, 0), z = row(transform, 2, d, 0);
    double l = std::sqrt(x * x + y * y + z * z);
    return glm::vec3(x / l, y / l, z / l);
}

glm::vec3 transform_position(glm::mat4 const& transform, glm::vec3 const& p)
{
    return glm::vec3(row(transform, 0, p, 1), row(transform, 1, p, 1), row(transform, 2, p, 1));
}

glm::vec3 transform_direction_to_object_space(glm::vec3 const& d, glm::vec3 const& normal, glm::vec3 const& tangent,
                                              glm::vec3 const& bitangent)
{
    glm::dmat3 const m(tangent, normal, bitangent);
    return glm::vec3(glm::normalize(m * glm::dvec3(d)));
}
