#pragma once
#include <cstdint>

/// What a child does to its memory so that reading what was never written, and keeping what is not needed, shows.
namespace testat {
/// Gives the unused stack, and from now on every new block of the heap, the byte `fill`; nothing if it is 0. Blocks
/// that malloc takes from its cache (GLIBC_TUNABLES=glibc.malloc.tcache_count=0 leaves it none) keep their content.
void prepare_memory(std::uint32_t fill);

/// Gives the next few kilobytes of the unused stack the byte `fill`; nothing if it is 0. What the caller calls next
/// finds it in its variables.
void fill_stack(std::uint32_t fill);

/// Bytes of the heap that are in use.
double heap_in_use();
}  // namespace testat
