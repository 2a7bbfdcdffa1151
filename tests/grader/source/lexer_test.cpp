#include "source/lexer.h"

#include <gtest/gtest.h>

namespace testat {
namespace {
using Names = std::vector<std::string>;

TEST(Lex, FindsIncludesInOrder)
{
    EXPECT_EQ(lex("#include <a.h>\n # include \"b/c.h\" // first\nint x;\n#include<d.h>\n").includes,
              (Names{"a.h", "b/c.h", "d.h"}));
}

TEST(Lex, IncludesInCommentsAndLiteralsAreNone)
{
    EXPECT_EQ(lex("// #include <a.h>\n/*\n#include <b.h>\n*/\nauto s = R\"(\n#include <c.h>\n)\";\n").includes,
              Names());
}

TEST(Lex, IncludesThatDependOnSomethingAreLeftOut)
{
    EXPECT_EQ(lex("#if X\n#include <a.h>\n#endif\n#include <b.h>\n").includes, Names{"b.h"});
    EXPECT_EQ(lex("#if 0\n#include <a.h>\n#if 1\n#endif\n#endif\n#include <b.h>\n").includes, Names{"b.h"});
    EXPECT_EQ(lex("#include <a.h>\n#define M\n#include <b.h>\n").includes, Names{"a.h"});
}

TEST(Lex, CommentsBeginAndEndAcrossContinuedLines)
{
    EXPECT_EQ(lex("/\\\n/ a\n/\\\r\n* b *\\\n\\\n/ c").tokens.size(), 1u);
    EXPECT_EQ(lex("/\\\n* no end *\\\n").tokens.size(), 0u);
    EXPECT_EQ(lex("/ /\\\n").tokens.size(), 2u);
}

TEST(Lex, BrokenIncludesAreLeftOut)
{
    EXPECT_EQ(lex("#include\n#include <a.h\n#include \"\n#include MACRO\n#include").includes, Names());
}
}  // namespace
}  // namespace testat
