#include "batch/written.h"

#include "process/run.h"

#include <gtest/gtest.h>

namespace testat {
namespace {
/// Names what a batch writes that makes "a" and "b" from these.
std::string written_by(std::filesystem::path const& file, std::string const& a, std::string const& b, bool is_there)
{
    std::string names;
    Written written(file);
    written.update("a", is_there, a, [&] { names += "a"; });
    written.update("b", is_there, b, [&] { names += "b"; });
    written.remember();
    return names;
}
}  // namespace

TEST(Written, IsOnlyWhatHasChangedOrIsNotThere)
{
    TemporaryDirectory const place;
    auto const file = place.path() / "written.json";
    EXPECT_EQ(written_by(file, "1", "1", true), "ab");
    EXPECT_EQ(written_by(file, "1", "1", true), "");
    EXPECT_EQ(written_by(file, "1", "2", true), "b");
    EXPECT_EQ(written_by(file, "1", "2", false), "ab");
}

TEST(Written, IsEverythingWhereTheListIsDamaged)
{
    TemporaryDirectory const place;
    auto const file = place.path() / "written.json";
    written_by(file, "1", "1", true);
    for (char const* damaged : {"[]", "{", R"({"a": 1, "b": []})"}) {
        write_file(file, damaged);
        EXPECT_EQ(written_by(file, "1", "1", true), "ab") << damaged;
    }
}
}  // namespace testat
