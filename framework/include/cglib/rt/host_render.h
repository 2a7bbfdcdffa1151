#pragma once

#include <cglib/core/image.h>
#include <cglib/core/thread_local_data.h>
#include <cglib/core/thread_pool.h>

#include <cstdint>
#include <functional>

/// The colour (linear rgb) of the pixel in column x from the left and row y from the bottom.
using PixelFunction = std::function<glm::vec3(int x, int y, ThreadLocalData& thread)>;

/// The seed of a pixel's random numbers, which depends on its position only.
std::uint32_t pixel_seed(int x, int y, int width);

/// Fills the image on the calling thread, row by row from the bottom; alpha is 1.
/// The random numbers of a pixel depend on its position only.
void host_render(PixelFunction const& pixel, Image* image);

/// The same picture, rows being shared among the threads of the pool. pixel is called concurrently.
void host_render(PixelFunction const& pixel, ThreadPool& pool, Image* image);
