#include <cglib/rt/object.h>

std::unique_ptr<Object> create_sphere(glm::vec3 const& center, float radius, float scale_uv)
{
    return std::make_unique<Object>(std::make_shared<Sphere>(center, radius),
                                    std::make_shared<SphericalMapping>(center, scale_uv));
}

std::unique_ptr<Object> create_plane(glm::vec3 const& center, glm::vec3 const& normal, float scale_uv)
{
    return create_plane(center, normal, default_tangent(glm::normalize(normal)), scale_uv);
}

std::unique_ptr<Object> create_plane(glm::vec3 const& center, glm::vec3 const& normal, glm::vec3 const& tangent,
                                     float scale_uv)
{
    return create_plane(center, normal, tangent, glm::cross(tangent, glm::normalize(normal)), scale_uv);
}

std::unique_ptr<Object> create_plane(glm::vec3 const& center, glm::vec3 const& normal, glm::vec3 const& tangent,
                                     glm::vec3 const& bitangent, float scale_uv)
{
    return std::make_unique<Object>(std::make_shared<Plane>(center, normal),
                                    std::make_shared<PlanarMapping>(center, normal, tangent, bitangent, scale_uv));
}

std::unique_ptr<Object> create_quad(glm::vec3 const& center, glm::vec3 const& normal, glm::vec3 const& e0,
                                    glm::vec3 const& e1, float scale_uv)
{
    glm::vec3 const corner = center - 0.5f * (e0 + e1);
    return std::make_unique<Object>(std::make_shared<Quad>(center, e0, e1),
                                    std::make_shared<PlanarMapping>(corner, normal, e0, e1, scale_uv));
}
