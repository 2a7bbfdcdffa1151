#include "packed_texels.h"

#include "picture_file.h"

#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>

namespace {
/// For memory that is filled at once: a fault for every 2 MB instead of every 4 kB, where the system offers that.
void use_large_pages(void* memory, std::size_t size)
{
    auto const page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
    auto const begin = (reinterpret_cast<std::uintptr_t>(memory) + page - 1) / page * page;
    auto const end = (reinterpret_cast<std::uintptr_t>(memory) + size) / page * page;
    if (begin < end)
        madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
}
}  // namespace

PackedTexels::PackedTexels(std::shared_ptr<TexelBytes const> bytes, float gamma)
    : bytes_(std::move(bytes)), color_(decoding_table(255, gamma)), alpha_(decoding_table(255, 1.f))
{
}

std::vector<glm::vec4> PackedTexels::unpack() const
{
    std::size_t const count = std::size_t(width()) * std::size_t(height());
    std::vector<glm::vec4> texels;
    texels.reserve(count);
    use_large_pages(texels.data(), count * sizeof(glm::vec4));
    for (std::size_t i = 0; i < count; ++i)
        texels.push_back(at(i));
    return texels;
}
