#include <cglib/rt/host_render.h>

#include <gtest/gtest.h>

namespace {
glm::vec3 position_and_noise(int x, int y, ThreadLocalData& thread)
{
    return glm::vec3(float(x), float(y), thread.rand());
}
}  // namespace

TEST(HostRender, EachPixelGetsItsColour)
{
    Image image(3, 2);
    host_render(position_and_noise, &image);
    EXPECT_EQ(glm::vec2(image.getPixel(2, 1)), glm::vec2(2.f, 1.f));
    EXPECT_EQ(image.getPixel(0, 0).w, 1.f);
}

TEST(HostRender, ThreadsMakeTheSamePicture)
{
    Image alone(16, 16);
    Image together(16, 16);
    ThreadPool pool(3);
    host_render(position_and_noise, &alone);
    host_render(position_and_noise, pool, &together);
    EXPECT_EQ(alone.getPixels(), together.getPixels());
}
