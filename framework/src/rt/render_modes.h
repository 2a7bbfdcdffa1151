#pragma once

#include <cglib/rt/ray.h>
#include <cglib/rt/render_data.h>

/// The colour (linear rgb) that the active render mode gives a camera ray.
glm::vec3 render_ray(RenderData& data, Ray const& ray);
