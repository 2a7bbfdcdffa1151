#include "watch/saves.h"

#include <gtest/gtest.h>

#include <fstream>
#include <thread>

namespace testat {
namespace {
void save(std::filesystem::path const& file)
{
    std::ofstream(file) << "int x;\n";
}

class SavesOf : public testing::Test {
protected:
    TemporaryDirectory place;
    std::filesystem::path file = place.path() / "exercise_03.cpp";
};

TEST_F(SavesOf, AnEditorThatWritesIntoTheFile)
{
    save(file);
    Saves saves(file);
    save(file);
    saves.wait();
}

TEST_F(SavesOf, AnEditorThatRenamesOverTheFile)
{
    save(file);
    Saves saves(file);
    save(place.path() / "new");
    std::filesystem::rename(place.path() / "new", file);
    saves.wait();
}

TEST_F(SavesOf, AnEditorThatDeletesTheFileFirst)
{
    save(file);
    Saves saves(file);
    save(file);
    std::filesystem::remove(file);
    std::thread later([&] {
        wait_for(0.2);
        save(file);
    });
    saves.wait();
    EXPECT_TRUE(std::filesystem::exists(file));
    later.join();
}

/// What happens to others is no save: the second wait is for the file itself.
TEST_F(SavesOf, NothingElse)
{
    save(file);
    Saves saves(file);
    save(file);
    saves.wait();
    save(place.path() / "other.cpp");
    std::thread later([&] {
        wait_for(0.2);
        std::filesystem::remove(place.path() / "other.cpp");
        save(file);
    });
    saves.wait();
    EXPECT_FALSE(std::filesystem::exists(place.path() / "other.cpp"));
    later.join();
}

TEST_F(SavesOf, AFolderThatGoesAway)
{
    std::filesystem::create_directory(place.path() / "folder");
    Saves saves(place.path() / "folder/file");
    std::filesystem::remove(place.path() / "folder");
    EXPECT_THROW(saves.wait(), std::runtime_error);
    EXPECT_THROW(Saves(place.path() / "folder/file"), std::invalid_argument);
}
}  // namespace
}  // namespace testat
