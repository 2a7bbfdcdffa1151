#include "source/includes.h"

#include "process/run.h"
#include "report/report.h"

#include <gtest/gtest.h>

namespace testat {
namespace {
/// A framework of three headers: a.h includes b.h, which includes a.h.
class Includes : public testing::Test {
protected:
    Includes()
    {
        std::filesystem::create_directories(root_.path() / "cglib");
        write_file(root_.path() / "cglib/a.h", "#include <cglib/b.h>\n");
        write_file(root_.path() / "cglib/b.h", "#include <cglib/a.h>\n#include <vector>\n");
        write_file(root_.path() / "cglib/c.h", "int c;\n");
    }

    TemporaryDirectory root_;
};

using Headers = std::set<std::string>;

TEST_F(Includes, GoThroughOneAnother)
{
    EXPECT_EQ(included_headers("#include <cglib/a.h>\n#include <cmath>\n", root_.path()),
              (Headers{"cglib/a.h", "cglib/b.h"}));
}

TEST_F(Includes, OfHeadersThatDoNotExistAreNone)
{
    EXPECT_EQ(included_headers("#include <cglib/x.h>\n#include <cglib/../cglib/c.h>\n", root_.path()), Headers());
}
}  // namespace
}  // namespace testat
