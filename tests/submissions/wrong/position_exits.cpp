// verdict: {"loses": {"transform_position": [1, 1]}, "says": {"transform_position": "crashed"}, "policy": []}
// exit(0) in a function that no picture calls: costs the function and nothing else.
#include <cstdlib>

glm::vec3 transform_position(glm::mat4 const& transform, glm::vec3 const& p)
{
    std::exit(transform[3][3] == 1.f && p == p ? 0 : 1);
}
