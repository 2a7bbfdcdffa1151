#pragma once

#include <cglib/rt/intersection.h>
#include <cglib/rt/render_data.h>

/// The colour (linear rgb) that the render mode of the context shows along a ray from the camera.
glm::vec3 render_ray(RenderData& data, Ray const& ray);
