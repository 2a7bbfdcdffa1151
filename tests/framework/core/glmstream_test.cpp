#include <cglib/core/glmstream.h>

#include <gtest/gtest.h>

#include <sstream>

namespace {
template <class Value>
std::string text(Value const& value)
{
    std::ostringstream out;
    out << value;
    return out.str();
}
}  // namespace

TEST(Glmstream, VectorsAreTuples)
{
    EXPECT_EQ(text(glm::vec2(1.f, 2.f)), "(1, 2)");
    EXPECT_EQ(text(glm::vec3(1.f, -2.5f, 3.f)), "(1, -2.5, 3)");
    EXPECT_EQ(text(glm::vec4(1.f, 2.f, 3.f, 4.f)), "(1, 2, 3, 4)");
}

TEST(Glmstream, MatricesAreWrittenByRows)
{
    glm::mat3 m(1.f);
    m[2][0] = 7.f;
    EXPECT_EQ(text(m), "(1, 0, 7)\n(0, 1, 0)\n(0, 0, 1)");
    EXPECT_EQ(text(glm::mat4(2.f)), "(2, 0, 0, 0)\n(0, 2, 0, 0)\n(0, 0, 2, 0)\n(0, 0, 0, 2)");
}
