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

Bounds Intersectable::bounds(glm::mat4 const&) const
{
    return Bounds();
}

Sphere::Sphere(glm::vec3 const& sphere_center, float sphere_radius) : center(sphere_center), radius(sphere_radius) {}

bool Sphere::intersect(Ray const& ray, Intersection* isect) const
{
    float t;
    if (!intersect_sphere(ray.origin, ray.direction, center, radius, &t) || !set_hit(ray, t, isect))
        return false;
    set_normal(glm::normalize(isect->position - center), isect);
    return true;
}

Bounds Sphere::bounds(glm::mat4 const& transform) const
{
    // An ellipsoid reaches as far along an axis as the matrix' row for that axis is long.
    glm::mat3 const rows = glm::transpose(glm::mat3(transform));
    glm::vec3 const reach = radius * glm::vec3(glm::length(rows[0]), glm::length(rows[1]), glm::length(rows[2]));
    glm::vec3 const middle(transform * glm::vec4(center, 1.f));
    return {middle - reach, middle + reach};
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

Bounds Quad::bounds(glm::mat4 const& transform) const
{
    glm::vec3 const corner = center - 0.5f * (e0 + e1);
    glm::vec3 corners[] = {corner, corner + e0, corner + e1, corner + e0 + e1};
    for (glm::vec3& c : corners)
        c = glm::vec3(transform * glm::vec4(c, 1.f));
    return Bounds::around(corners, 4);
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
