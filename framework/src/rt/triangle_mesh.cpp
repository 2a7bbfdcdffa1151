#include <cglib/rt/triangle_mesh.h>

#include <cglib/core/assert.h>

#include <algorithm>

namespace {
glm::vec3 unit_in_plane(glm::vec3 const& direction, glm::vec3 const& normal)
{
    glm::vec3 const in_plane = direction - glm::dot(direction, normal) * normal;
    float const length = glm::length(in_plane);
    return length > 0.f ? in_plane / length : default_tangent(normal);
}
}  // namespace

TriangleMesh::TriangleMesh(std::vector<Vertex> vertices, std::vector<Triangle> triangles)
    : vertices_(std::move(vertices)), triangles_(std::move(triangles))
{
    int const count = int(vertices_.size());
    for (Triangle const& t : triangles_)
        for (int const index : {t.a, t.b, t.c})
            cg_assert(index >= 0 && index < count);
}

bool TriangleMesh::intersect(Ray const& ray, Intersection* isect) const
{
    int hit = -1;
    float nearest = FLT_MAX;
    for (int i = 0; i < int(triangles_.size()); ++i) {
        float t;
        if (!meets(i, ray, &t) || !(t < nearest))
            continue;
        nearest = t;
        hit = i;
    }
    if (hit < 0)
        return false;
    isect->t = nearest;
    isect->position = ray.origin + nearest * ray.direction;
    isect->geometric_normal = isect->normal = normal(triangles_[std::size_t(hit)]);
    isect->uv = uv_at(hit, isect->position);
    isect->primitive_id = std::uint32_t(hit);
    return true;
}

bool TriangleMesh::meets(int triangle, Ray const& ray, float* t) const
{
    Triangle const& corners = triangles_[std::size_t(triangle)];
    if (!intersect_plane(ray.origin, ray.direction, corner(corners.a).position, normal(corners), t))
        return false;
    glm::vec3 const lambda = barycentric(triangle, ray.origin + *t * ray.direction);
    return lambda.x >= 0.f && lambda.y >= 0.f && lambda.z >= 0.f;
}

Bounds TriangleMesh::bounds(glm::mat4 const& transform) const
{
    if (has_slivers())
        return Bounds();
    std::vector<glm::vec3> positions;
    for (Vertex const& vertex : vertices_)
        positions.emplace_back(transform * glm::vec4(vertex.position, 1.f));
    return positions.empty() ? Bounds() : Bounds::around(positions.data(), int(positions.size()));
}

/// Of a triangle a hundred times as long as high, barycentric coordinates in float no longer say who is inside.
bool TriangleMesh::has_slivers() const
{
    float const least_height = 0.01f;
    for (Triangle const& t : triangles_) {
        glm::vec3 const ab = corner(t.b).position - corner(t.a).position;
        glm::vec3 const ac = corner(t.c).position - corner(t.a).position;
        float const longest = std::max({glm::dot(ab, ab), glm::dot(ac, ac), glm::dot(ac - ab, ac - ab)});
        if (!(glm::length(glm::cross(ab, ac)) >= least_height * longest))
            return true;
    }
    return false;
}

glm::vec3 TriangleMesh::normal(Triangle const& triangle) const
{
    glm::vec3 const a = corner(triangle.a).position;
    return glm::normalize(glm::cross(corner(triangle.b).position - a, corner(triangle.c).position - a));
}

glm::vec3 TriangleMesh::barycentric(int triangle, glm::vec3 const& position) const
{
    Triangle const& corners = triangles_[std::size_t(triangle)];
    glm::vec3 const a = corner(corners.a).position;
    glm::vec3 const b = corner(corners.b).position;
    glm::vec3 const c = corner(corners.c).position;
    // Signed areas, each twice as large and times the whole, which cancels.
    glm::vec3 const whole = glm::cross(b - a, c - a);
    float const area = glm::dot(whole, whole);
    float const of_b = glm::dot(glm::cross(c - a, a - position), whole) / area;
    float const of_c = glm::dot(glm::cross(a - position, b - a), whole) / area;
    return glm::vec3(1.f - of_b - of_c, of_b, of_c);
}

glm::vec2 TriangleMesh::uv_at(int triangle, glm::vec3 const& position) const
{
    Triangle const& corners = triangles_[std::size_t(triangle)];
    glm::vec3 const lambda = barycentric(triangle, position);
    return lambda.x * corner(corners.a).uv + lambda.y * corner(corners.b).uv + lambda.z * corner(corners.c).uv;
}

glm::vec3 TriangleMesh::tangent(int triangle) const
{
    Triangle const& corners = triangles_[std::size_t(triangle)];
    Vertex const& a = corner(corners.a);
    glm::vec3 const to_b = corner(corners.b).position - a.position;
    glm::vec3 const to_c = corner(corners.c).position - a.position;
    glm::vec2 const uv_to_b = corner(corners.b).uv - a.uv;
    glm::vec2 const uv_to_c = corner(corners.c).uv - a.uv;
    // Along dP/du v stays the same: uv_to_c.y * to_b - uv_to_b.y * to_c, up to the sign of the texture's area.
    float const area = uv_to_b.x * uv_to_c.y - uv_to_c.x * uv_to_b.y;
    glm::vec3 const along = uv_to_c.y * to_b - uv_to_b.y * to_c;
    return unit_in_plane(area < 0.f ? -along : along, normal(corners));
}

MeshMapping::MeshMapping(std::shared_ptr<TriangleMesh const> mesh) : mesh_(std::move(mesh)) {}

glm::vec2 MeshMapping::get_uv(Intersection const& isect) const
{
    return mesh_->uv_at(int(isect.primitive_id), isect.position);
}

void MeshMapping::compute_tangent_space(Intersection* isect) const
{
    isect->tangent = mesh_->tangent(int(isect->primitive_id));
    isect->bitangent = glm::cross(isect->tangent, isect->normal);
}
