#include "probe/memory.h"

#include <malloc.h>

#include <cstring>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
// Of sanitizer/allocator_interface.h, which GCC 12 does not install.
extern "C" std::size_t __sanitizer_get_current_allocated_bytes();
#endif

namespace testat {
namespace {
/// Its own frame is what it fills, and so that of the function called next, but for a few bytes at its upper end.
template <std::size_t size>
[[gnu::noinline]] void fill_frame(int byte)
{
    unsigned char frame[size];
    std::memset(frame, byte, size);
    asm volatile("" : : "r"(frame) : "memory");  // or the compiler would leave it out
}

constexpr std::size_t whole_stack = 256 << 10;
constexpr std::size_t next_frames = 4 << 10;  ///< of a student's function and what it calls
}  // namespace

void prepare_memory(std::uint32_t fill)
{
    if (fill == 0)
        return;
    fill_frame<whole_stack>(int(fill));
    mallopt(M_PERTURB, int(fill ^ 0xff));  // new blocks get the complement
}

void fill_stack(std::uint32_t fill)
{
    if (fill != 0)
        fill_frame<next_frames>(int(fill));
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
