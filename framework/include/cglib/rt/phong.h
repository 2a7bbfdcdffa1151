#pragma once

#include <cglib/rt/intersection.h>
#include <cglib/rt/ray.h>
#include <cglib/rt/render_data.h>

/// The light (linear rgb) that a hit sends back along the ray, summed over all lights:
/// (visible * (k_d max(0, N.L) + k_s max(0, R.V)^n if N.L > 0) + k_a) * power / distance^2.
/// N is the shading normal with normal mapping, else the normal. The back of what is not transmissive is black.
glm::vec3 phong(RenderData& data, Ray const& ray, Intersection const& isect);
