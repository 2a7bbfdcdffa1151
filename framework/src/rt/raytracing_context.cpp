#include <cglib/rt/raytracing_context.h>

namespace {
thread_local RaytracingContext* active = nullptr;
}

RaytracingContext* RaytracingContext::get_active()
{
    static RaytracingContext defaults;
    return active ? active : &defaults;
}

RaytracingContext::Activation::Activation(RaytracingContext& context) : previous_(active)
{
    active = &context;
}

RaytracingContext::Activation::~Activation()
{
    active = previous_;
}
