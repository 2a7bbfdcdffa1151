#pragma once

#include <cglib/rt/bounds.h>
#include <cglib/rt/intersection.h>
#include <cglib/rt/intersection_tests.h>
#include <cglib/rt/ray.h>

#include <glm/glm.hpp>

/// A shape that rays can hit.
class Intersectable {
public:
    virtual ~Intersectable();

    /// True if the ray hits at some t > 0. Then position, geometric_normal, normal and t of *isect are set (uv too
    /// where the shape has some); else *isect may be anything.
    virtual bool intersect(Ray const& ray, Intersection* isect) const = 0;

    /// Contains the shape after an affine transform. Unbounded unless a shape knows better.
    virtual Bounds bounds(glm::mat4 const& transform) const;
};

/// All points at one distance from a centre. Normals point outward.
class Sphere : public Intersectable {
public:
    /// radius > 0.
    Sphere(glm::vec3 const& center, float radius);
    bool intersect(Ray const& ray, Intersection* isect) const override;
    Bounds bounds(glm::mat4 const& transform) const override;

    glm::vec3 center;
    float radius;
};

/// An infinite plane, hit from both sides.
class Plane : public Intersectable {
public:
    /// center is any point on the plane; the normal is normalised.
    Plane(glm::vec3 const& center, glm::vec3 const& normal);
    bool intersect(Ray const& ray, Intersection* isect) const override;

    glm::vec3 center;
    glm::vec3 normal;
};

/// A parallelogram, hit from both sides: center + (u - 0.5) e0 + (v - 0.5) e1 with (u, v) in [0, 1]^2.
class Quad : public Intersectable {
public:
    /// The normal is normalize(cross(e0, e1)).
    Quad(glm::vec3 const& center, glm::vec3 const& e0, glm::vec3 const& e1);

    /// Sets uv as well.
    bool intersect(Ray const& ray, Intersection* isect) const override;
    Bounds bounds(glm::mat4 const& transform) const override;

    glm::vec3 center;
    glm::vec3 e0;
    glm::vec3 e1;
    glm::vec3 normal;

private:
    /// (u, v) of a point in the quad's plane.
    glm::vec2 coordinates(glm::vec3 const& position) const;
};
