#pragma once

#include <cglib/rt/intersectable.h>
#include <cglib/rt/texture_mapping.h>

#include <glm/glm.hpp>

#include <memory>
#include <vector>

/// Triangles with texture coordinates at their corners, hit from both sides.
class TriangleMesh : public Intersectable {
public:
    struct Vertex {
        glm::vec3 position;
        glm::vec2 uv;
    };
    /// Indices of three vertices, counter-clockwise seen from outside.
    struct Triangle {
        int a, b, c;
    };

    /// Indices must be valid (asserted), triangles must have an area.
    TriangleMesh(std::vector<Vertex> vertices, std::vector<Triangle> triangles);

    /// Sets uv, and primitive_id to the triangle's index, as well.
    bool intersect(Ray const& ray, Intersection* isect) const override;
    /// Unbounded if a triangle is so thin that hits may be found outside.
    Bounds bounds(glm::mat4 const& transform) const override;

    /// Barycentric coordinates (lambda_A, lambda_B, lambda_C) of a point in the plane of a triangle: the areas of the
    /// triangles that it makes with the opposite edges, over the area of the whole. They add up to 1, and are negative
    /// outside.
    glm::vec3 barycentric(int triangle, glm::vec3 const& position) const;

    /// Texture coordinates at a point in the plane of a triangle: those of its corners, weighted with the barycentric
    /// coordinates.
    glm::vec2 uv_at(int triangle, glm::vec3 const& position) const;

    /// The direction (unit) in which u grows on a triangle; some direction in its plane if u does not.
    glm::vec3 tangent(int triangle) const;

private:
    Vertex const& corner(int index) const { return vertices_[std::size_t(index)]; }
    glm::vec3 normal(Triangle const& triangle) const;
    bool has_slivers() const;
    bool meets(int triangle, Ray const& ray, float* t) const;

    std::vector<Vertex> vertices_;
    std::vector<Triangle> triangles_;
};

/// The texture coordinates of a mesh, continued over the plane of the triangle that was hit: so a footprint has a size.
class MeshMapping : public TextureMapping {
public:
    explicit MeshMapping(std::shared_ptr<TriangleMesh const> mesh);
    glm::vec2 get_uv(Intersection const& isect) const override;
    void compute_tangent_space(Intersection* isect) const override;

private:
    std::shared_ptr<TriangleMesh const> mesh_;
};
