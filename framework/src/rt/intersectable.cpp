#include <cglib/rt/intersectable.h>

namespace {
/// False for a hit so far away that its position would not be a number.
bool set_hit(Ray const& ray, float t, Intersection* isect)
{
    isect->t = t;
    isect->position = ray.origin + t * ray.direction;
    return t < FLT_MAX;
}

void set_normal(glm::vec3 const& normal, Intersection* isect)
{
    isect->geometric_normal = normal;
    isect->normal = normal;
}
}  // namespace

Intersectable::~Intersectable() = default;

Sphere::Sphere(glm::vec3 const& sphere_center, float sphere_radius) : center(sphere_center), radius(sphere_radius) {}

bool Sphere::intersect(Ray const& ray, Intersection* isect) const
{
    float t;
    if (!intersect_sphere(ray.origin, ray.direction, center, radius, &t) || !set_hit(ray, t, isect))
        return false;
    set_normal(glm::normalize(isect->position - center), isect);
    return true;
}

Plane::Plane(glm::vec3 const& plane_center, glm::vec3 const& plane_normal)
    : center(plane_center), normal(glm::normalize(plane_normal))
{
}

bool Plane::intersect(Ray const& ray, Intersection* isect) const
{
    float t;
    if (!intersect_plane(ray.origin, ray.direction, center, normal, &t) || !set_hit(ray, t, isect))
        return false;
    set_normal(normal, isect);
    return true;
}

Quad::Quad(glm::vec3 const& quad_center, glm::vec3 const& edge0, glm::vec3 const& edge1)
    : center(quad_center), e0(edge0), e1(edge1), normal(glm::normalize(glm::cross(edge0, edge1)))
{
}

bool Quad::intersect(Ray const& ray, Intersection* isect) const
{
    float t;
    if (!intersect_plane(ray.origin, ray.direction, center, normal, &t) || !set_hit(ray, t, isect))
        return false;
    set_normal(normal, isect);
    isect->uv = coordinates(isect->position);
    return isect->uv.x >= 0.f && isect->uv.x <= 1.f && isect->uv.y >= 0.f && isect->uv.y <= 1.f;
}

glm::vec2 Quad::coordinates(glm::vec3 const& position) const
{
    // Cramer's rule for center + a e0 + b e1 = position, in the plane of the edges.
    glm::vec3 const d = position - center;
    float const area = glm::length(glm::cross(e0, e1));
    float const a = glm::dot(glm::cross(d, e1), normal) / area;
    float const b = glm::dot(glm::cross(e0, d), normal) / area;
    return glm::vec2(a + 0.5f, b + 0.5f);
}
