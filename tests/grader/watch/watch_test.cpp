// `testat watch` as its users see it; no test depends on how long something takes.
#include "end_to_end/testat_program.h"

#include <gtest/gtest.h>

#include <csignal>

namespace testat {
namespace {
/// A `testat watch` at work, and what it has printed. Ended by Ctrl-C.
class Watching {
public:
    Watching(std::filesystem::path const& place, std::vector<std::string> const& more)
        : place_(place), program_(arguments(place, more), {"LC_ALL=C.UTF-8"}, place / "stdout", place / "stderr")
    {
    }

    /// Waits until it has printed `words` once more than it had.
    bool says(std::string const& words)
    {
        constexpr int patience = 3000;
        for (int i = 0; i < patience; ++i) {
            std::string const all = printed();
            if (auto const found = all.find(words, read_); found != std::string::npos) {
                read_ = found + words.size();
                return true;
            }
            wait_for(0.05);
        }
        return false;
    }

    std::string printed() const { return read_file(place_ / "stdout"); }

    int interrupt() const
    {
        program_.send(SIGINT);
        return program_.wait();
    }

private:
    static std::vector<std::string> arguments(std::filesystem::path const& place, std::vector<std::string> const& more)
    {
        std::vector<std::string> all{
            "watch", (place / "exercise_03.cpp").string(), "--out", (place / "out").string(), "--tasks", "b"};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }

    std::filesystem::path place_;
    Running program_;
    std::size_t read_ = 0;
};

TEST(Watch, TellsWhatEachSaveChanges)
{
    TemporaryDirectory const place;
    auto const file = place.path() / "exercise_03.cpp";
    write_file(file, reference_text());
    Watching watching(place.path(), {});
    EXPECT_TRUE(watching.says("exercise_03.cpp: 2.00 of 2.00 points\n")) << watching.printed();

    write_file(place.path() / "new",
               patched_reference("int ImageTexture::wrap_clamp(int, int)\n{\n    return 0;\n}\n"));
    std::filesystem::rename(place.path() / "new", file);
    EXPECT_TRUE(watching.says("wrap_clamp")) << watching.printed();

    write_file(file, "int x = ;\n");
    EXPECT_TRUE(watching.says("exercise_03.cpp:1: error:")) << watching.printed();

    std::filesystem::remove(file);
    write_file(file, reference_text());
    EXPECT_TRUE(watching.says("(+2.00)")) << watching.printed();
    EXPECT_EQ(watching.interrupt(), 130);
}

TEST(Watch, SpeaksGerman)
{
    TemporaryDirectory const place;
    write_file(place.path() / "exercise_03.cpp", reference_text());
    Watching watching(place.path(), {"--lang", "de"});
    EXPECT_TRUE(watching.says("2.00 von 2.00 Punkten")) << watching.printed();
    EXPECT_EQ(watching.interrupt(), 130);
}

TEST(Watch, NeedsAFile)
{
    TemporaryDirectory const place;
    Outcome const ran = run_testat({"watch", (place.path() / "nothing.cpp").string()});
    EXPECT_EQ(ran.exit_code, 2);
    EXPECT_NE(ran.err.find("nothing.cpp"), std::string::npos) << ran.err;
    EXPECT_EQ(run_testat({"watch"}).exit_code, 2);
}
}  // namespace
}  // namespace testat
