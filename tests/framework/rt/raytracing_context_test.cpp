#include <cglib/rt/raytracing_context.h>

#include <gtest/gtest.h>

#include <thread>

TEST(RaytracingContext, DefaultsAreActiveAtFirst)
{
    ASSERT_NE(RaytracingContext::get_active(), nullptr);
    EXPECT_TRUE(RaytracingContext::get_active()->params.transform_objects);
}

TEST(RaytracingContext, ActivationsNest)
{
    RaytracingContext outer;
    RaytracingContext inner;
    RaytracingContext::Activation const first(outer);
    {
        RaytracingContext::Activation const second(inner);
        EXPECT_EQ(RaytracingContext::get_active(), &inner);
    }
    EXPECT_EQ(RaytracingContext::get_active(), &outer);
}

TEST(RaytracingContext, EachThreadActivatesItsOwn)
{
    RaytracingContext context;
    RaytracingContext::Activation const activation(context);
    RaytracingContext* seen = &context;
    std::thread([&] { seen = RaytracingContext::get_active(); }).join();
    EXPECT_NE(seen, &context);
}
