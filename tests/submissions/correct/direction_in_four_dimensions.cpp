// verdict: {"loses": {}}
// Normalises all four components, of which the last is zero.
glm::vec3 transform_direction(glm::mat4 const& transform, glm::vec3 const& d)
{
    glm::vec4 v = glm::normalize(transform * glm::vec4(d, 0.f));
    return glm::vec3(v.x, v.y, v.z);
}

glm::vec3 transform_position(glm::mat4 const& m, glm::vec3 const& p)
{
    glm::vec3 r(0.0f);
    for (int row = 0; row < 3; row++) { for (int col = 0; col < 3; col++) r[row] += m[col][row] * p[col]; r[row] += m[3][row]; }
    return r;
}
