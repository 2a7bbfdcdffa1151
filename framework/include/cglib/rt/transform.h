#pragma once

#include <cglib/rt/intersection.h>
#include <cglib/rt/ray.h>
#include <cglib/rt/raytracing_context.h>

#include <glm/glm.hpp>
// Submissions use glm::inverse, glm::scale and the like.
#include <glm/gtc/matrix_transform.hpp>

/// STUDENT, task e. The direction d after transform (homogeneous coordinate 0), unit.
glm::vec3 transform_direction(glm::mat4 const& transform, glm::vec3 const& d);

/// STUDENT, task e. The position p after transform (homogeneous coordinate 1). transform is affine.
glm::vec3 transform_position(glm::mat4 const& transform, glm::vec3 const& p);

/// STUDENT, task f. The direction d, given in tangent space, as a unit direction in object space. x is along the
/// tangent, y along the normal, z along the bitangent; all three are unit, in object space.
glm::vec3 transform_direction_to_object_space(glm::vec3 const& d, glm::vec3 const& normal, glm::vec3 const& tangent,
                                              glm::vec3 const& bitangent);

/// The ray after transform; its direction is unit again. Unchanged if the active context has transform_objects off.
Ray transform_ray(Ray const& ray, glm::mat4 const& transform);

/// The position by transform; normals and tangents by transform_normal, unit; t, uv, dudv and material stay as they
/// are, and so do vectors that have not been set yet. Unchanged if the active context has transform_objects off.
Intersection transform_intersection(Intersection const& isect, glm::mat4 const& transform,
                                    glm::mat4 const& transform_normal);
