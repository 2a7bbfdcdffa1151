#include "compile/compile.h"
#include "process/run.h"
#include "report/report.h"
#include "text.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

namespace testat {
namespace {
class ReadSubmission : public testing::Test {
protected:
    Submission read(std::string const& bytes)
    {
        write_file(file_, bytes);
        return read_submission(file_);
    }

    TemporaryDirectory directory_;
    std::filesystem::path file_ = directory_.path() / "exercise_03.cpp";
};
}  // namespace

TEST_F(ReadSubmission, GivesTextNameAndHash)
{
    Submission const submission = read("int x;\n");
    EXPECT_EQ(submission.text, "int x;\n");
    EXPECT_EQ(submission.file, "exercise_03.cpp");
    EXPECT_EQ(submission.sha256, sha256("int x;\n"));
    EXPECT_FALSE(submission.refused);
}

TEST_F(ReadSubmission, RefusesEmptyFiles)
{
    EXPECT_EQ(read("").refused, "the file is empty");
    EXPECT_EQ(read(" \t\r\n\n").refused, "the file is empty");
}

TEST_F(ReadSubmission, RefusesBinaryFiles)
{
    EXPECT_TRUE(read(std::string("int x;\0", 7)).refused);
    EXPECT_TRUE(read("\x7f"
                     "ELF\x02\x01")
                    .refused);
    EXPECT_EQ(read(std::string("int x;\0", 7)).text, "");
}

TEST_F(ReadSubmission, LeavesAFewControlCharactersToTheCompiler)
{
    EXPECT_FALSE(read("// pasted \x02 from a document\n" + std::string(1000, ' ') + "int x;\n").refused);
}

TEST_F(ReadSubmission, NamesTheFileOnOneLine)
{
    write_file(directory_.path() / "a\nb\x1b[31m.cpp", "int x;\n");
    EXPECT_EQ(read_submission(directory_.path() / "a\nb\x1b[31m.cpp").file, "a b[31m.cpp");
}

TEST_F(ReadSubmission, RefusesUtf16)
{
    EXPECT_TRUE(read(std::string("\xff\xfei\0n\0t\0 \0x\0;\0\n\0", 16)).refused);
    EXPECT_TRUE(read(std::string("\xfe\xff\0i\0n\0t\0 \0x\0;\0\n", 16)).refused);
}

TEST_F(ReadSubmission, RefusesMoreThanAMegabyte)
{
    EXPECT_FALSE(read(std::string(1'000'000, ' ').replace(0, 1, "x")).refused);
    EXPECT_EQ(read(std::string(1'000'001, ' ').replace(0, 1, "x")).refused, "the file is larger than 1 MB");
}

TEST_F(ReadSubmission, DoesNotEvenReadAQuarterOfAGigabyte)
{
    write_file(file_, "int x;");
    std::filesystem::resize_file(file_, (256u << 20) + 1);
    EXPECT_EQ(read_submission(file_).refused, "the file is larger than 1 MB");
    EXPECT_EQ(read_submission(file_).sha256, "");
}

TEST_F(ReadSubmission, TakesLatin1AndUtf8)
{
    EXPECT_EQ(read("// gr\xfc\xdf"
                   "e\nint x;")
                  .text,
              "// gr\xfc\xdf"
              "e\nint x;");
    EXPECT_FALSE(read("\xef\xbb\xbf// gr\xc3\xbc\xc3\x9f"
                      "e\r\n\f\v\tint x;")
                     .refused);
}

TEST_F(ReadSubmission, HashesWhatItRefuses)
{
    EXPECT_EQ(read("").sha256, sha256(""));
}

TEST_F(ReadSubmission, ThrowsIfThereIsNoFile)
{
    EXPECT_THROW(read_submission(directory_.path() / "nothing.cpp"), UnreadableInput);
    EXPECT_THROW(read_submission(directory_.path()), UnreadableInput);
}

TEST_F(ReadSubmission, ThrowsForWhatIsNoFile)
{
    ASSERT_EQ(mkfifo(file_.c_str(), 0600), 0);
    EXPECT_THROW(read_submission(file_), UnreadableInput);
    EXPECT_THROW(read_submission("/dev/null"), UnreadableInput);
}

TEST_F(ReadSubmission, FollowsLinks)
{
    write_file(file_, "int x;");
    std::filesystem::create_symlink(file_, directory_.path() / "link.cpp");
    EXPECT_EQ(read_submission(directory_.path() / "link.cpp").text, "int x;");
}
}  // namespace testat
