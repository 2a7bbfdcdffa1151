#include "probe/memory.h"

#include "sanitizers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

namespace testat {
namespace {
/// Whether a variable that nobody has set holds this byte, but for what calls leave on the stack.
[[gnu::noinline]] bool is_stack_filled_with(unsigned char byte)
{
    unsigned char unset[256];
    asm volatile("" : "=m"(unset));
    return std::count(std::begin(unset), std::end(unset), byte) >= 256 - 32;
}

bool is_block_filled_with(unsigned char byte, std::size_t size)
{
    auto* const block = static_cast<unsigned char*>(std::malloc(size));
    asm volatile("" : "=m"(*block) : "r"(block) : "memory");
    bool const filled = std::all_of(block, block + size, [=](unsigned char c) { return c == byte; });
    std::free(block);
    return filled;
}

/// Does not come back, as it changes the heap of the process.
[[noreturn]] void look_at_blocks()
{
    prepare_memory(0xc1);
    bool filled = true;
    for (std::size_t size : {5'000u, 100'000u, 1'000'000u})
        filled = filled && is_block_filled_with(0xc1, size);
    std::_Exit(filled ? 0 : 1);
}
}  // namespace

TEST(FillStack, ShowsInVariablesThatNobodySets)
{
    if (is_sanitized)
        GTEST_SKIP() << "the sanitizer lays out the stack";
    for (unsigned char byte : {0x40, 0xc1}) {
        fill_stack(byte);
        EXPECT_TRUE(is_stack_filled_with(byte)) << int(byte);
    }
}

TEST(FillStack, LeavesTheStackAloneWithoutFill)
{
    if (is_sanitized)
        GTEST_SKIP() << "the sanitizer lays out the stack";
    fill_stack(0x40);
    fill_stack(0);
    EXPECT_TRUE(is_stack_filled_with(0x40));
}

TEST(PrepareMemory, ShowsInBlocksThatNobodySets)
{
    if (is_sanitized)
        GTEST_SKIP() << "the sanitizer's heap";
    EXPECT_EXIT(look_at_blocks(), testing::ExitedWithCode(0), "");
}

TEST(HeapInUse, GrowsByWhatIsKept)
{
    constexpr std::size_t size = 100'000;
    double const before = heap_in_use();
    void* const block = std::malloc(size);
    asm volatile("" : : "r"(block) : "memory");  // or the compiler would leave it out
    double const with = heap_in_use();
    std::free(block);
    EXPECT_GE(with - before, double(size));
    EXPECT_LE(with - before, double(size) + 10'000);
    EXPECT_LE(heap_in_use() - before, 10'000.0);
}
}  // namespace testat
