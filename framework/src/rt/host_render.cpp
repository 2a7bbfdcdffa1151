#include <cglib/rt/host_render.h>

namespace {
/// Seeds of neighbouring pixels must not be neighbours, or their sequences would look alike.
std::uint32_t seed_of(int x, int y, int width)
{
    return (std::uint32_t(y) * std::uint32_t(width) + std::uint32_t(x)) * 2654435769u;
}

void render_row(PixelFunction const& pixel, int y, Image* image)
{
    ThreadLocalData thread;
    for (int x = 0; x < image->getWidth(); ++x) {
        thread.set_seed(seed_of(x, y, image->getWidth()));
        image->setPixel(x, y, glm::vec4(pixel(x, y, thread), 1.f));
    }
}
}  // namespace

void host_render(PixelFunction const& pixel, Image* image)
{
    for (int y = 0; y < image->getHeight(); ++y)
        render_row(pixel, y, image);
}

void host_render(PixelFunction const& pixel, ThreadPool& pool, Image* image)
{
    pool.run(image->getHeight(), [&](int y) { render_row(pixel, y, image); });
}
