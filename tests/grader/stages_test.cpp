#include "stages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <thread>

namespace testat {
TEST(Stages, AddUpWhatBeginsWithTheSameWords)
{
    Stages stages;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    stages.end("observe: pictures");
    stages.end("check");
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    stages.end("observe: unit checks");
    EXPECT_GE(stages.wall_ms("observe"), 3);
    EXPECT_GE(stages.wall_ms(), stages.wall_ms("observe") + stages.wall_ms("check"));
    EXPECT_EQ(stages.wall_ms("render"), 0);
}

TEST(Stages, AreToldOnceEachInOrder)
{
    Stages stages;
    for (char const* name : {"compile", "observe", "check", "observe"})
        stages.end(name);
    std::string const table = stages.table();
    EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 5) << table;
    EXPECT_LT(table.find("compile"), table.find("observe"));
    EXPECT_LT(table.find("observe"), table.find("check"));
    EXPECT_LT(table.find("check"), table.find("total"));
}
}  // namespace testat
