#pragma once

#include <cglib/core/thread_local_data.h>
#include <cglib/rt/ray.h>
#include <cglib/rt/raytracing_context.h>

/// What is carried along while the colour of one sample is computed.
struct RenderData {
    /// For one sample; both must outlive it.
    RenderData(RaytracingContext const& active_context, ThreadLocalData& rendering_thread)
        : context(active_context), thread(rendering_thread)
    {
    }

    /// The scene and the parameters.
    RaytracingContext const& context;
    /// Of the thread that renders the sample.
    ThreadLocalData& thread;

    /// The rays through the pixel's corners in the order (-,-) (+,+) (-,+) (+,-), set where has_corner_rays is true.
    Ray corner_rays[4];
    bool has_corner_rays = false;

    /// Rays met with the scene so far, those to the lights included.
    int num_rays = 0;
};
