#include <cglib/rt/host_render.h>

namespace {
void render_row(PixelFunction const& pixel, int y, Image* image)
{
    ThreadLocalData thread;
    for (int x = 0; x < image->getWidth(); ++x) {
        thread.set_seed(pixel_seed(x, y, image->getWidth()));
        image->setPixel(x, y, glm::vec4(pixel(x, y, thread), 1.f));
    }
}
}  // namespace

std::uint32_t pixel_seed(int x, int y, int width)
{
    // Seeds of neighbouring pixels must not be neighbours, or their sequences would look alike.
    return (std::uint32_t(y) * std::uint32_t(width) + std::uint32_t(x)) * 2654435769u;
}

void host_render(PixelFunction const& pixel, Image* image)
{
    for (int y = 0; y < image->getHeight(); ++y)
        render_row(pixel, y, image);
}

void host_render(PixelFunction const& pixel, ThreadPool& pool, Image* image)
{
    pool.run(image->getHeight(), [&](int y) { render_row(pixel, y, image); });
}
