#include "probe/variables.h"

#include "sanitizers.h"

#include <dlfcn.h>

#include <gtest/gtest.h>

namespace testat {
namespace {
int volatile counter = 0;
}

TEST(Variables, HaveChangedOnceOneIsWritten)
{
    if (is_sanitized)
        GTEST_SKIP() << "the sanitizer makes the program's variables more than are looked at";
    void* const program = dlopen(nullptr, RTLD_NOW);
    Variables const variables(program);
    bool const before = variables.have_changed();
    counter = counter + 1;
    bool const after = variables.have_changed();
    counter = counter - 1;
    bool const restored = variables.have_changed();
    EXPECT_FALSE(before);
    EXPECT_TRUE(after);
    EXPECT_FALSE(restored);
    dlclose(program);
}
}  // namespace testat
