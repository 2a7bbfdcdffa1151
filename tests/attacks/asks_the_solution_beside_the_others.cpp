// attack: {"at": "run", "earns": [17, 17], "says": {"transform_direction": "wrong", "transform_direction_to_object_space": "wrong"}}
// Two functions that only call each other; where both are the upload's, they look for their own bodies in the solution
// that answers for all others.
#include <dlfcn.h>
#include <link.h>

#include <string>

#ifndef WITHOUT_ATTACK
static thread_local int depth = 0;

struct Deeper {
    Deeper() { ++depth; }
    ~Deeper() { --depth; }
};

template <typename Function>
static Function* find(char const* symbol)
{
    for (link_map const* library = _r_debug.r_map; library != nullptr; library = library->l_next)
        if (std::string(library->l_name).find("/all.so") != std::string::npos)
            if (void* const handle = dlopen(library->l_name, RTLD_NOW | RTLD_NOLOAD))
                return reinterpret_cast<Function*>(dlsym(handle, symbol));
    return nullptr;
}

using Direction = glm::vec3(glm::mat4 const&, glm::vec3 const&);
using ToObjectSpace = glm::vec3(glm::vec3 const&, glm::vec3 const&, glm::vec3 const&, glm::vec3 const&);
#endif

glm::vec3 transform_direction(glm::mat4 const& transform, glm::vec3 const& direction)
{
#ifndef WITHOUT_ATTACK
    Deeper const deeper;
    if (depth <= 1)
        return transform_direction_to_object_space(direction, glm::vec3(transform[1]), glm::vec3(transform[0]),
                                                   glm::vec3(transform[2]));
    if (auto* const solution = find<Direction>(
            "_Z19transform_directionRKN3glm3matILi4ELi4EfLNS_9qualifierE0EEERKNS_3vecILi3EfLS1_0EEE"))
        return solution(transform, direction);
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
    if (auto* const solution = find<ToObjectSpace>(
            "_Z35transform_direction_to_object_spaceRKN3glm3vecILi3EfLNS_9qualifierE0EEES4_S4_S4_"))
        return solution(direction, normal, tangent, bitangent);
#endif
    return direction;
}
