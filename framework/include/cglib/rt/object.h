#pragma once

#include <cglib/rt/intersectable.h>
#include <cglib/rt/intersection.h>
#include <cglib/rt/material.h>
#include <cglib/rt/ray.h>
#include <cglib/rt/texture_mapping.h>
#include <cglib/rt/transform.h>

#include <glm/glm.hpp>

// Submissions use std::min({...}) and the like.
#include <algorithm>
#include <memory>

/// A shape with a material, a texture mapping and a place in the world.
class Object {
public:
    // First, so that vtable and type information live in the framework and not in the submission.
    virtual ~Object();

    /// Shape and mapping must not be null; the material may be replaced later.
    Object(std::shared_ptr<Intersectable> geo, std::shared_ptr<TextureMapping> texture_mapping);

    /// STUDENT, task e. Meets a ray in world space with the object. True if it is hit; then *isect tells where, in
    /// world space, t included. With transform_objects off, the shape is met as if it stood in the world.
    virtual bool intersect(Ray const& ray, Intersection* isect) const;

    /// Completes a hit (world space): tangent space, uv, material, shading normal. dudv becomes zero.
    /// Reads the active context; a material is sampled only if the render mode needs one.
    virtual void compute_shading_info(Intersection* isect);

    /// The same, with dudv from the four rays (world space) through the pixel's corners.
    virtual void compute_shading_info(const Ray rays[4], Intersection* isect);

    /// The texture coordinates of a hit in object space.
    virtual glm::vec2 get_uv(Intersection const& isect) const;

    /// The texture coordinates of four points near isect, all in object space; isect.uv is set already.
    /// (0, 1) and (2, 3) are opposite corners of a pixel. Where both differences of a pair to isect.uv point the same
    /// way along u or v, a seam of the mapping lies between them: the longer one is replaced by the mirrored shorter
    /// one.
    void get_intersection_uvs(glm::vec3 const positions[4], Intersection const& isect, glm::vec2 uvs[4]) const;

    /// STUDENT, task d. The size (du, dv) of the pixel's footprint in uv space, all arguments in object space.
    /// rays go through the pixel's corners in the order (-,-) (+,+) (-,+) (+,-), isect.uv is set already.
    glm::vec2 compute_uv_aabb_size(const Ray rays[4], Intersection const& isect);

    /// Sets all four matrices. The matrix must be invertible and affine.
    void set_transform_object_to_world(glm::mat4 const& transform);

    std::shared_ptr<Intersectable> geo;
    std::shared_ptr<Material> material;
    std::shared_ptr<TextureMapping> texture_mapping;

    glm::mat4 transform_object_to_world = glm::mat4(1.f);
    glm::mat4 transform_world_to_object = glm::mat4(1.f);
    /// For normals: the transposed inverse of transform_object_to_world.
    glm::mat4 transform_object_to_world_normal = glm::mat4(1.f);
    /// For normals: the transposed inverse of transform_world_to_object.
    glm::mat4 transform_world_to_object_normal = glm::mat4(1.f);

private:
    Intersection locate(Intersection const& isect) const;
    void apply_material(Intersection* isect) const;
    Intersection to_world_space(Intersection const& isect) const;
};

/// A sphere with spherical texture coordinates, which run from 0 to scale_uv.
std::unique_ptr<Object> create_sphere(glm::vec3 const& center, float radius, float scale_uv = 1.f);

/// A plane with texture coordinates zero at center, growing by 1 each scale_uv units along tangent and bitangent.
/// The bitangent is cross(tangent, normal) unless given, the tangent the default one of texture_mapping.h.
std::unique_ptr<Object> create_plane(glm::vec3 const& center, glm::vec3 const& normal, float scale_uv = 1.f);
std::unique_ptr<Object> create_plane(glm::vec3 const& center, glm::vec3 const& normal, glm::vec3 const& tangent,
                                     float scale_uv = 1.f);
std::unique_ptr<Object> create_plane(glm::vec3 const& center, glm::vec3 const& normal, glm::vec3 const& tangent,
                                     glm::vec3 const& bitangent, float scale_uv = 1.f);

/// A parallelogram around center with texture coordinates dot(p - corner, e) / scale_uv, where the corner is
/// center - e0/2 - e1/2: a texture fills it once if scale_uv is the squared length of (equally long) edges.
/// The normal is the one of the mapping; the shape's own is normalize(cross(e0, e1)).
std::unique_ptr<Object> create_quad(glm::vec3 const& center, glm::vec3 const& normal, glm::vec3 const& e0,
                                    glm::vec3 const& e1, float scale_uv = 1.f);
