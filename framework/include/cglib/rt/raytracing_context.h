#pragma once

#include <cglib/rt/raytracing_parameters.h>

struct Scene;

/// What is being rendered, and how.
class RaytracingContext {
public:
    /// Fixed while threads render.
    RaytracingParameters params;

    /// May be null where nothing is rendered, as in a test of a single function. Not owned.
    Scene* scene = nullptr;

    /// The context that the calling thread has activated last; without one, a context of default parameters that all
    /// threads share. Never null.
    static RaytracingContext* get_active();

    class Activation;
};

/// Makes a context the active one of the calling thread as long as it lives. Can be nested.
/// Threads that render one picture together each activate the same context.
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
