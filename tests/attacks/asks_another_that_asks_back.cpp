// attack: {"at": "run", "earns": [17, 17], "says": {"transform_direction": "wrong", "transform_direction_to_object_space": "wrong"}}
// Two functions that only call each other: alone, each is answered by the solution's other one.
#ifndef WITHOUT_ATTACK
static thread_local int depth = 0;

struct Deeper {
    Deeper() { ++depth; }
    ~Deeper() { --depth; }
};
#endif

glm::vec3 transform_direction(glm::mat4 const& transform, glm::vec3 const& direction)
{
#ifndef WITHOUT_ATTACK
    Deeper const deeper;
    if (depth <= 1)
        return transform_direction_to_object_space(direction, glm::vec3(transform[1]), glm::vec3(transform[0]),
                                                   glm::vec3(transform[2]));
#endif
    return direction;
}

glm::vec3 transform_direction_to_object_space(glm::vec3 const& direction, glm::vec3 const& normal,
                                              glm::vec3 const& tangent, glm::vec3 const& bitangent)
{
#ifndef WITHOUT_ATTACK
    Deeper const deeper;
    if (depth <= 1)
        return transform_direction(glm::mat4(glm::vec4(tangent, 0.f), glm::vec4(normal, 0.f), glm::vec4(bitangent, 0.f),
                                             glm::vec4(0.f, 0.f, 0.f, 1.f)),
                                   direction);
#endif
    return direction;
}
