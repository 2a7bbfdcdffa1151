#include "json_schema.h"
#include "process/run.h"
#include "report/report.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

namespace testat {
namespace {
std::string read(std::filesystem::path const& file)
{
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

std::size_t entries(std::filesystem::path const& directory)
{
    std::filesystem::directory_iterator const all(directory);
    return std::size_t(std::distance(begin(all), end(all)));
}
}  // namespace

TEST(WriteAtomically, WritesAndReplaces)
{
    TemporaryDirectory const directory;
    auto const file = directory.path() / "report.json";
    write_atomically(file, "old");
    EXPECT_EQ(read(file), "old");
    write_atomically(file, std::string("new\0bytes", 9));
    EXPECT_EQ(read(file), std::string("new\0bytes", 9));
    EXPECT_EQ(entries(directory.path()), 1u) << "no temporary file is left";
}

TEST(WriteAtomically, NamesAFileItCannotWrite)
{
    TemporaryDirectory const directory;
    write_file(directory.path() / "file", "");
    try {
        write_atomically(directory.path() / "file" / "report.json", "x");
        FAIL();
    } catch (std::runtime_error const& e) {
        EXPECT_NE(std::string(e.what()).find("report.json"), std::string::npos) << e.what();
    }
    EXPECT_THROW(write_atomically(directory.path() / "nothing" / "report.json", "x"), std::runtime_error);
}

TEST(WriteAtomically, LeavesTheOldOneIfItFails)
{
    TemporaryDirectory const directory;
    auto const old = directory.path() / "report.json";
    std::filesystem::create_directories(old / "not empty");  // cannot be replaced by a file
    EXPECT_THROW(write_atomically(old, "new"), std::runtime_error);
    EXPECT_TRUE(std::filesystem::is_directory(old / "not empty"));
    EXPECT_EQ(entries(directory.path()), 1u) << "no temporary file is left";
}

TEST(WriteFile, NamesAFileItCannotWrite)
{
    TemporaryDirectory const directory;
    EXPECT_THROW(write_file(directory.path() / "nothing" / "a", "x"), std::runtime_error);
}

TEST(ReadJson, NamesFileAndPlace)
{
    TemporaryDirectory const directory;
    write_file(directory.path() / "a.json", "{\n  \"a\": ]\n}");
    try {
        read_json(directory.path() / "a.json");
        FAIL();
    } catch (BadJson const& e) {
        EXPECT_NE(std::string(e.what()).find("a.json"), std::string::npos) << e.what();
        EXPECT_NE(std::string(e.what()).find("line 2"), std::string::npos) << e.what();
    }
}
}  // namespace testat
