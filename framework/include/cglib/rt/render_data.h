#pragma once

#include <cglib/core/thread_local_data.h>
#include <cglib/rt/raytracing_context.h>

#include <glm/glm.hpp>

/// What is carried along while the colour of one sample is computed.
struct RenderData {
    /// For one sample at an image position in pixels; context and thread data must outlive it.
    RenderData(RaytracingContext& active_context, ThreadLocalData& rendering_thread,
               glm::vec2 const& image_position = glm::vec2(0.f))
        : context(active_context), thread(rendering_thread), pixel(image_position)
    {
    }

    /// The scene and the parameters.
    RaytracingContext& context;
    /// Of the thread that renders the sample.
    ThreadLocalData& thread;
    /// (0.5, 0.5) is the centre of the lower left pixel.
    glm::vec2 pixel;
    /// Rays met with the scene so far, those to the lights included.
    int num_rays = 0;
};
