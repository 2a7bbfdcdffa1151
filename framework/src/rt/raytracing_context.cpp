#include <cglib/rt/raytracing_context.h>

namespace {
thread_local RaytracingContext* active = nullptr;
}

RaytracingContext* RaytracingContext::get_active()
{
    static thread_local RaytracingContext defaults;
    return active ? active : &defaults;
}

RenderPlan const* RaytracingContext::default_plan()
{
    static RenderPlan const plan;
    return &plan;
}

RaytracingContext::Activation::Activation(RaytracingContext& context) : previous_(active)
{
    active = &context;
}

RaytracingContext::Activation::~Activation()
{
    active = previous_;
}
