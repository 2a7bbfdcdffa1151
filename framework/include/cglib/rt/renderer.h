#pragma once

#include <cglib/core/image.h>
#include <cglib/rt/intersection.h>
#include <cglib/rt/ray.h>
#include <cglib/rt/raytracing_parameters.h>
#include <cglib/rt/render_data.h>

class Object;
struct Scene;

/// Renders the scene on the calling thread into the image, which becomes params.width x params.height.
/// Sets filter and wrap of the scene's textures; makes mip levels (the student's create_mipmap) only for a mode that
/// reads some, and only of textures that have level 0 alone. Activates a context of its own meanwhile.
void render_scene(Scene& scene, RaytracingParameters const& params, Image* image);

/// Sets filter and wrap of the scene's textures and makes what mip levels are needed, as render_scene does.
void prepare_textures(Scene& scene, RaytracingParameters const& params);

/// The colour (linear rgb) at an image position in pixels, (0.5, 0.5) being the centre of the lower left pixel.
/// The context must be active on the calling thread, its textures prepared.
glm::vec3 render_sample(RaytracingContext const& context, glm::vec2 const& pixel, ThreadLocalData& thread);

/// The ray from the scene's camera through an image position in pixels.
Ray camera_ray(RaytracingContext const& context, glm::vec2 const& pixel);

/// The object that the ray meets first, and where in *isect (world space, not completed yet); else null.
Object* find_nearest_hit(RenderData& data, Ray const& ray, Intersection* isect);

/// Whether nothing lies between two points in world space.
bool is_visible(RenderData& data, glm::vec3 const& from, glm::vec3 const& to);
