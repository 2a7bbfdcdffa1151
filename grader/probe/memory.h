#pragma once
#include <cstdint>

/// What a child does to its memory so that reading what was never written, and keeping what is not needed, shows.
namespace testat {
/// Gives the unused stack, the free blocks of the heap and all that it grows by the byte `fill`; nothing if it is 0.
/// Small blocks that are freed later keep what was in them.
void prepare_memory(std::uint32_t fill);

/// Gives the next few kilobytes of the unused stack the byte `fill`; nothing if it is 0. What the caller calls next
/// finds it in its variables.
void fill_stack(std::uint32_t fill);

/// Bytes of the heap that are in use.
double heap_in_use();
}  // namespace testat
