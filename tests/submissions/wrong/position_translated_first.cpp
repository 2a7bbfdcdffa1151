// verdict: {"loses": {"transform_position": [1, 1]}, "says": {"transform_position": "wrong"}, "policy": []}
// Translates first, then rotates.
glm::vec3 transform_position(glm::mat4 const& transform, glm::vec3 const& p)

{
    glm::vec3 moved = p + glm::vec3(transform[3]);
    return glm::mat3(transform) * moved;
}
