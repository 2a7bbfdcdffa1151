#pragma once

#include <cglib/core/image.h>
#include <cglib/rt/intersection.h>
#include <cglib/rt/ray.h>
#include <cglib/rt/raytracing_parameters.h>
#include <cglib/rt/render_data.h>
#include <cglib/rt/render_stats.h>

class Object;
struct Scene;

/// How the work of a picture is done. The picture is the same whatever is chosen.
struct RenderOptions {
    /// >= 1; a single one is the calling thread.
    int threads = 1;
    /// Objects that a ray cannot meet are not tested. Off, each ray is tested against each object: for an
    /// Object::intersect that finds hits where nothing is.
    bool culling = true;
};

/// Renders the scene into the image, which becomes params.width x params.height. Loads the textures that the picture
/// needs, sets their filter and wrap, and makes mip levels (the student's create_mipmap) only for a mode that reads
/// some, and only of textures that have level 0 alone. Throws std::runtime_error if a texture is missing.
RenderStats render_scene(Scene& scene, RaytracingParameters const& params, Image* image,
                         RenderOptions const& options = RenderOptions());

/// The colour (linear rgb) at an image position in pixels, (0.5, 0.5) being the centre of the lower left pixel.
/// The context must be active on the calling thread, and prepared as PreparedRender does it.
glm::vec3 render_sample(RaytracingContext& context, glm::vec2 const& pixel, ThreadLocalData& thread);

/// The ray from the scene's camera through an image position in pixels.
Ray camera_ray(RaytracingContext const& context, glm::vec2 const& pixel);

/// The object that the ray meets first (of equally near ones the first of the scene), and where in *isect (world space,
/// not completed yet); else null.
Object* find_nearest_hit(RenderData& data, Ray const& ray, Intersection* isect);

/// Whether nothing lies between two points in world space.
bool is_visible(RenderData& data, glm::vec3 const& from, glm::vec3 const& to);
