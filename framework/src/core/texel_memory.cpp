#include "texel_memory.h"

#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>

namespace {
/// Best effort: without it the pages come one by one.
void bring_pages(void* memory, std::size_t size)
{
    auto const page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
    auto const begin = (reinterpret_cast<std::uintptr_t>(memory) + page - 1) / page * page;
    auto const end = (reinterpret_cast<std::uintptr_t>(memory) + size) / page * page;
    constexpr std::size_t worth_a_call = 16;
    if (begin + worth_a_call * page > end)
        return;
    madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
#ifdef MADV_POPULATE_WRITE
    madvise(reinterpret_cast<void*>(begin), end - begin, MADV_POPULATE_WRITE);
#endif
}
}  // namespace

std::vector<glm::vec4> reserve_texels(std::size_t count)
{
    std::vector<glm::vec4> texels;
    texels.reserve(count);
    bring_pages(texels.data(), count * sizeof(glm::vec4));
    return texels;
}
