#pragma once

#include <cglib/rt/raytracing_parameters.h>
#include <cglib/rt/render_plan.h>
#include <cglib/rt/render_stats.h>

struct Scene;
class Culling;

/// What is being rendered, and how. Threads that render one picture together have a context each.
class RaytracingContext {
public:
    /// Fixed while pixels are rendered.
    RaytracingParameters params;

    /// May be null where nothing is rendered, as in a test of a single function. Not owned, nor are the others.
    Scene* scene = nullptr;
    /// Never null; by default the plan for default parameters.
    RenderPlan const* plan = default_plan();
    /// Null: every ray is tested against every object.
    Culling const* culling = nullptr;
    /// Counts up while this context is active.
    RenderStats stats;

    /// The context that the calling thread has activated last; without one, a context of default parameters, one for
    /// each thread. Never null.
    static RaytracingContext* get_active();

    static RenderPlan const* default_plan();

    class Activation;
};

/// Makes a context the active one of the calling thread as long as it lives. Can be nested.
class RaytracingContext::Activation {
public:
    /// The context must outlive this object.
    explicit Activation(RaytracingContext& context);

    /// The context that was active before is active again.
    ~Activation();

    Activation(Activation const&) = delete;
    Activation& operator=(Activation const&) = delete;

private:
    RaytracingContext* previous_;
};
