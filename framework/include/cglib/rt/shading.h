#pragma once

#include <cglib/rt/intersection.h>
#include <cglib/rt/ray.h>
#include <cglib/rt/render_data.h>

class Object;

/// The light (linear rgb) that comes back along the camera ray: what it hits, shaded, reflections and refractions
/// included, or the environment.
glm::vec3 trace_camera_ray(RenderData& data, Ray const& ray);

/// Completes the hit of a camera ray, with its footprint if the plan wants it.
void complete_camera_hit(RenderData& data, Object& object, Intersection* isect);

/// Whether the ray sees the back of a surface that lets nothing through: then it is black.
bool is_dark_side(Ray const& ray, Intersection const& isect);

/// The light (linear rgb) that a completed hit sends back along the ray, summed over all lights:
/// (visible * (k_d max(0, N.L) + k_s max(0, R.V)^n if N.L > 0) + k_a) * power / distance^2.
/// N is the shading normal. Nothing from a dark side.
glm::vec3 phong(RenderData& data, Ray const& ray, Intersection const& isect);

/// What is seen of the environment in a direction (unit): the texture at x = (atan2(z, x) + pi) / 2pi,
/// y = (asin(y) + pi/2) / pi, level 0, nearest for NEAREST, else bilinear; black if there is none.
glm::vec3 look_up_environment(RenderData& data, glm::vec3 const& direction);

/// The share of light that is reflected at a border between media (Fresnel's equations for unpolarised light).
/// cos_in >= 0 belongs to the side the light comes from; eta is the index of refraction of that side over the other's.
/// 1 for total reflection.
float fresnel(float cos_in, float eta);
