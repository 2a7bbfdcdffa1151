#include "probe/variables.h"

#include <dlfcn.h>
#include <link.h>

#include <algorithm>

namespace testat {
namespace {
constexpr std::size_t largest = 1 << 20;

struct Segment {
    std::byte const* begin;
    std::size_t size;
};

struct Search {
    ElfW(Addr) base;
    std::vector<Segment> writable;
};

int find_writable(dl_phdr_info* library, std::size_t, void* data)
{
    auto& search = *static_cast<Search*>(data);
    if (library->dlpi_addr != search.base)
        return 0;
    for (int i = 0; i < library->dlpi_phnum; ++i) {
        auto const& header = library->dlpi_phdr[i];
        if (header.p_type == PT_LOAD && (header.p_flags & PF_W) != 0)
            search.writable.push_back(
                {reinterpret_cast<std::byte const*>(library->dlpi_addr + header.p_vaddr), header.p_memsz});
    }
    return 1;
}

std::vector<Segment> writable_segments(void* library)
{
    link_map* map = nullptr;
    if (dlinfo(library, RTLD_DI_LINKMAP, &map) != 0)
        return {};
    Search search{map->l_addr, {}};
    dl_iterate_phdr(find_writable, &search);
    return search.writable;
}
}  // namespace

Variables::Variables(void* library)
{
    for (auto const& segment : writable_segments(library)) {
        too_large_ = too_large_ || segment.size > largest;
        if (!too_large_)
            parts_.push_back({segment.begin, {segment.begin, segment.begin + segment.size}});
    }
}

bool Variables::have_changed() const
{
    return too_large_ || std::any_of(parts_.begin(), parts_.end(), [](Part const& part) {
               return !std::equal(part.before.begin(), part.before.end(), part.begin);
           });
}
}  // namespace testat
