#include "probe/memory.h"

#include <malloc.h>

#include <array>
#include <cstdlib>
#include <cstring>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#include <sanitizer/allocator_interface.h>
#endif

namespace testat {
namespace {
constexpr std::size_t all_bytes = 256 << 10;
constexpr std::size_t frame_bytes = 4 << 10;  ///< of a student's function and what it calls

/// Its own frame is what it fills.
[[gnu::noinline]] void fill_frame(int byte, std::size_t size)
{
    void* const below = __builtin_alloca(size);
    std::memset(below, byte, size);
    asm volatile("" : : "r"(below) : "memory");  // or the compiler would leave it out
}

/// The small blocks that malloc has at hand from before; it hands those out as they are.
void fill_free_blocks(int byte)
{
    constexpr std::size_t largest = 1032;
    constexpr std::size_t kept_of_each = 8;
    for (std::size_t size = 24; size <= largest; size += 16) {
        std::array<void*, kept_of_each> blocks;
        for (void*& block : blocks)
            if ((block = std::malloc(size)) != nullptr)
                std::memset(block, byte, size);
        for (void* block : blocks)
            std::free(block);
    }
}
}  // namespace

void prepare_memory(std::uint32_t fill)
{
    if (fill == 0)
        return;
    fill_frame(int(fill), all_bytes);
    mallopt(M_PERTURB, int(fill ^ 0xff));  // new blocks get the complement
    fill_free_blocks(int(fill));
}

void fill_stack(std::uint32_t fill)
{
    if (fill != 0)
        fill_frame(int(fill), frame_bytes);
}

double heap_in_use()
{
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    return double(__sanitizer_get_current_allocated_bytes());
#else
    auto const heap = mallinfo2();
    return double(heap.uordblks) + double(heap.hblkhd);
#endif
}
}  // namespace testat
