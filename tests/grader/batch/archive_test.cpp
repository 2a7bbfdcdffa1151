#include "batch/archive.h"

#include "batch/zips.h"
#include "process/run.h"
#include "report/report.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace testat {
namespace {
namespace fs = std::filesystem;

class Unpack : public testing::Test {
protected:
    Contents unpack_raw(std::vector<RawItem> const& items)
    {
        write_file(zip_, raw_zip(items));
        return unpack(zip_, to_);
    }

    Contents unpack_items(std::vector<ZipItem> const& items)
    {
        write_zip(zip_, items);
        return unpack(zip_, to_);
    }

    /// Everything below the temporary folder is either the zip or below `to_`.
    void expect_nothing_outside()
    {
        for (auto const& entry : fs::directory_iterator(root_.path()))
            EXPECT_TRUE(entry.path() == zip_ || entry.path() == to_) << entry.path();
        for (auto const& entry : fs::recursive_directory_iterator(to_))
            EXPECT_FALSE(entry.is_symlink()) << entry.path();
    }

    /// Refused with a message that has these words; nothing stays behind.
    void expect_thrown(std::string const& bytes, std::string const& words, UnpackLimits const& limits = {})
    {
        try {
            write_file(zip_, bytes);
            unpack(zip_, to_, limits);
            ADD_FAILURE() << "was unpacked";
        } catch (std::invalid_argument const& error) {
            EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
        }
        EXPECT_TRUE(fs::is_empty(to_));
    }

    void expect_left_out(RawItem const& item, std::string const& words)
    {
        Contents const contents = unpack_raw({item, {"good.cpp"}});
        ASSERT_EQ(contents.entries.size(), 1u);
        EXPECT_EQ(contents.entries[0].name, "good.cpp");
        ASSERT_EQ(contents.remarks.size(), 1u);
        EXPECT_NE(contents.remarks[0].find(words), std::string::npos) << contents.remarks[0];
        expect_nothing_outside();
    }

    TemporaryDirectory root_;
    fs::path zip_ = root_.path() / "all.zip";
    fs::path to_ = root_.path() / "to";
};
}  // namespace

TEST_F(Unpack, GivesNamesBytesAndTimes)
{
    Contents const contents = unpack_items({{"Sheet/", ""}, {"Sheet/a.cpp", "int a;", 1'700'000'000}});
    ASSERT_EQ(contents.entries.size(), 2u);
    EXPECT_TRUE(contents.entries[0].file.empty());
    EXPECT_EQ(contents.entries[1].name, "Sheet/a.cpp");
    EXPECT_EQ(contents.entries[1].file.filename(), "a.cpp");
    EXPECT_EQ(bytes_of(contents.entries[1].file), "int a;");
    EXPECT_EQ(contents.entries[1].modified, 1'700'000'000);
    EXPECT_TRUE(contents.remarks.empty());
}

TEST_F(Unpack, WritesFilesThatOnlyTheOwnerReads)
{
    Contents const contents = unpack_items({{"a.cpp", "int a;"}});
    EXPECT_EQ(fs::status(contents.entries.at(0).file).permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(Unpack, LeavesOutAbsolutePaths)
{
    expect_left_out({(root_.path() / "outside.cpp").string()}, "absolute");
}

TEST_F(Unpack, LeavesOutPathsWithADrive)
{
    expect_left_out({"C:\\Users\\a.cpp"}, "absolute");
}

TEST_F(Unpack, LeavesOutPathsThatLeave)
{
    expect_left_out({"a/../../outside.cpp"}, "'..'");
}

TEST_F(Unpack, LeavesOutPathsThatLeaveWithBackslashes)
{
    expect_left_out({"a\\..\\..\\outside.cpp"}, "'..'");
}

TEST_F(Unpack, LeavesOutEntriesWithoutAName)
{
    expect_left_out({""}, "no name");
}

TEST_F(Unpack, LeavesOutWhatLiesTooDeep)
{
    std::string name = "a.cpp";
    for (std::size_t i = 0; i < max_depth; ++i)
        name = "a/" + name;
    expect_left_out({name}, "too many folders");
}

TEST_F(Unpack, LeavesOutLinks)
{
    expect_left_out({"link.cpp", "/etc/passwd", 0, 0120777}, "a link");
}

TEST_F(Unpack, LeavesOutDevices)
{
    expect_left_out({"device.cpp", "", 0, 0020666}, "a device");
}

TEST_F(Unpack, LeavesOutEncryptedEntries)
{
    expect_left_out({"secret.cpp", "123456789012345", 1}, "encrypted");
}

TEST_F(Unpack, LeavesOutWhatIsTooLarge)
{
    expect_left_out({"large.cpp", "int x;", 0, 0100644, 0, 100u << 20}, "larger than 64 MB");
}

TEST_F(Unpack, DoesNotWriteThroughALinkOfTheZip)
{
    Contents const contents =
        unpack_items({{"out", "", {}, root_.path().string()}, {"out/evil.cpp", "int evil;"}, {"out", "int x;"}});
    EXPECT_EQ(contents.entries.size(), 2u);
    expect_nothing_outside();
    EXPECT_FALSE(fs::exists(root_.path() / "evil.cpp"));
}

TEST_F(Unpack, LeavesOutBombs)
{
    Contents const contents = unpack_items({{"bomb.cpp", std::string(8 << 20, 'a')}, {"good.cpp", "int x;"}});
    ASSERT_EQ(contents.entries.size(), 1u);
    ASSERT_EQ(contents.remarks.size(), 1u);
    EXPECT_NE(contents.remarks[0].find("1/100"), std::string::npos);
    EXPECT_EQ(std::distance(fs::directory_iterator(to_), fs::directory_iterator()), 1);
}

TEST_F(Unpack, CountsBytesOfAllEntries)
{
    UnpackLimits limits;
    limits.bytes = 19;
    std::string const twenty = raw_zip({{"a.cpp", "0123456789"}, {"b.cpp", "0123456789"}});
    expect_thrown(twenty, "stopped at 'b.cpp'", limits);
    limits.bytes = 20;
    write_file(zip_, twenty);
    EXPECT_EQ(unpack(zip_, to_, limits).entries.size(), 2u);
}

TEST_F(Unpack, LeavesOutWhatIsBeyondTheLimit)
{
    UnpackLimits limits;
    limits.entry_bytes = 5;
    write_file(zip_, raw_zip({{"a.cpp", "012345"}, {"b.cpp", "01234"}}));
    EXPECT_EQ(unpack(zip_, to_, limits).entries.at(0).name, "b.cpp");
}

TEST_F(Unpack, StopsAtTooManyEntries)
{
    std::string const two = raw_zip({{"a.cpp"}, {"b.cpp"}});
    UnpackLimits limits;
    limits.entries = 1;
    expect_thrown(two, "more than 1 entries", limits);
}

TEST_F(Unpack, RefusesWhatIsNoZip)
{
    expect_thrown("int main() {}", "not a zip");
    expect_thrown("", "not a zip");
}

TEST_F(Unpack, RefusesHalfAZip)
{
    std::string const whole = raw_zip({{"a.cpp"}, {"b.cpp"}});
    expect_thrown(whole.substr(0, whole.size() / 2), "not a zip");
}

TEST_F(Unpack, RefusesWrongChecksums)
{
    expect_thrown(raw_zip({{"good.cpp"}, {"bad.cpp", "int x;", 0, 0100644, 1}}), "is damaged in 'bad.cpp'");
}

TEST_F(Unpack, RefusesSizesBeyondItsEnd)
{
    expect_thrown(raw_zip({{"long.cpp", "int x;", 0, 0100644, 0, 1u << 20}}), "is damaged");
}

TEST_F(Unpack, RefusesADirectoryWithFiles)
{
    fs::create_directory(to_);
    write_file(to_ / "mine.txt", "mine");
    EXPECT_THROW(unpack_raw({{"a.cpp"}}), std::runtime_error);
    EXPECT_EQ(bytes_of(to_ / "mine.txt"), "mine");
}

TEST_F(Unpack, KeepsLettersOfAllKinds)
{
    for (std::uint16_t flags : {0, 0x800}) {
        std::string const name = "Müller_王_محمد_O'Neil.cpp";
        Contents const contents = unpack_raw({{name, "int x;", flags}});
        ASSERT_EQ(contents.entries.size(), 1u);
        EXPECT_EQ(contents.entries[0].name, name);
        fs::remove_all(to_);
    }
}

TEST_F(Unpack, ReplacesBrokenUtf8)
{
    Contents const contents = unpack_raw({{"M\xfcller\xc3/a\x1b[31m.cpp"}});
    ASSERT_EQ(contents.entries.size(), 1u);
    EXPECT_EQ(contents.entries[0].name, "M\xef\xbf\xbdller\xef\xbf\xbd/a[31m.cpp");
    EXPECT_EQ(bytes_of(contents.entries[0].file), "int x;");
}

TEST_F(Unpack, LeavesOutNamesThatClaimToBeUtf8)
{
    expect_left_out({"M\xfcller.cpp", "int x;", 0x800}, "UTF-8");
}

TEST_F(Unpack, KeepsBothOfTheSameName)
{
    Contents const contents = unpack_raw({{"a.cpp", "1"}, {"a.cpp", "2"}, {"A.CPP", "3"}, {"a.cpp/b.cpp", "4"}});
    ASSERT_EQ(contents.entries.size(), 4u);
    std::string all;
    for (auto const& entry : contents.entries)
        all += bytes_of(entry.file);
    std::sort(all.begin(), all.end());
    EXPECT_EQ(all, "1234");
}

TEST_F(Unpack, SurvivesNamesThatNoDiskTakes)
{
    Contents const contents =
        unpack_raw({{std::string(1000, 'a') + ".cpp"}, {"a:b*?.cpp"}, {"-rf.cpp"}, {std::string("a\0b.cpp", 7)}});
    EXPECT_EQ(contents.entries.size(), 4u);
    for (auto const& entry : contents.entries)
        EXPECT_TRUE(fs::is_regular_file(entry.file));
    expect_nothing_outside();
}

TEST_F(Unpack, PassesOverWhatSystemsLeaveBehind)
{
    Contents const contents = unpack_raw({{"__MACOSX/._a.cpp"}, {"Sheet/.DS_Store"}, {"Sheet/._a.cpp"}, {"Thumbs.db"}});
    EXPECT_TRUE(contents.entries.empty());
    EXPECT_TRUE(contents.remarks.empty());
}

TEST_F(Unpack, TakesBackslashesForSlashes)
{
    EXPECT_EQ(unpack_raw({{"Sheet\\Submissions\\a.cpp"}}).entries.at(0).name, "Sheet/Submissions/a.cpp");
}

TEST_F(Unpack, LeavesZipsInTheZipPacked)
{
    std::string const inner = raw_zip({{"inner.cpp"}});
    Contents const contents = unpack_raw({{"inner.zip", inner}});
    ASSERT_EQ(contents.entries.size(), 1u);
    EXPECT_EQ(bytes_of(contents.entries[0].file), inner);
}

TEST(ListFolder, LeavesOutLinksAndHiddenFiles)
{
    TemporaryDirectory const root;
    fs::create_directories(root.path() / "a/.git");
    write_file(root.path() / "a/.git/b.cpp", "");
    write_file(root.path() / "a/c.cpp", "");
    fs::create_symlink("/etc/passwd", root.path() / "a/d.cpp");
    fs::create_directory_symlink("/", root.path() / "e");
    Contents const contents = list_folder(root.path());
    ASSERT_EQ(contents.entries.size(), 2u);
    EXPECT_EQ(contents.entries[1].name, "a/c.cpp");
    EXPECT_EQ(contents.remarks.size(), 2u);
}
}  // namespace testat
