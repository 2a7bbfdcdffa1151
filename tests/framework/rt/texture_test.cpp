#include <cglib/rt/texture.h>

#include "pictures.h"
#include "temporary_directory.h"

#include <gtest/gtest.h>

#include <stdexcept>

struct TextureAccess {
    static std::vector<std::shared_ptr<Image>>& levels(ImageTexture& texture) { return texture.mip_levels; }
};

namespace {
ImageTexture numbered_texture(TextureFilterMode filter, TextureWrapMode wrap)
{
    return ImageTexture(numbered_image(4, 2), filter, wrap);
}
}  // namespace

TEST(Texture, ModesHaveNames)
{
    EXPECT_STREQ(tex_filter_mode_names[DEBUG_MIP], "Debug Mip");
    EXPECT_STREQ(tex_filter_mode_names[WHITE], "White");
    EXPECT_STREQ(tex_wrap_mode_names[TextureWrapMode::ZERO], "Zero");
}

TEST(ConstTexture, HasNoAlpha)
{
    EXPECT_EQ(ConstTexture(glm::vec3(1.f, 2.f, 3.f)).evaluate(glm::vec2(9.f)), glm::vec4(1.f, 2.f, 3.f, 0.f));
}

TEST(ImageTexture, LoadsLevelZeroOnly)
{
    TemporaryDirectory const directory;
    numbered_image(4, 2).save(directory.path("a.png"), 2.f);
    ImageTexture const texture(directory.path("a.png"), NEAREST, CLAMP);
    ASSERT_EQ(texture.get_mip_levels().size(), 1u);
    EXPECT_NEAR(texture.get_texel(0, 3, 1).r, 7.f / 8.f, 0.01f);
    EXPECT_THROW(ImageTexture(directory.path("b.png"), NEAREST, CLAMP), std::runtime_error);
}

TEST(GetTexel, InsideIsThePixelWhateverTheWrap)
{
    for (TextureWrapMode wrap : {REPEAT, CLAMP, ZERO})
        EXPECT_EQ(numbered_texture(NEAREST, wrap).get_texel(0, 2, 1), numbered_image(4, 2).getPixel(2, 1));
}

TEST(GetTexel, OutsideIsWrapped)
{
    Image const image = numbered_image(4, 2);
    EXPECT_EQ(numbered_texture(NEAREST, REPEAT).get_texel(0, -1, 2), image.getPixel(3, 0));
    EXPECT_EQ(numbered_texture(NEAREST, CLAMP).get_texel(0, -1, 2), image.getPixel(0, 1));
    EXPECT_EQ(numbered_texture(NEAREST, ZERO).get_texel(0, -1, 1), glm::vec4(0.f));
    EXPECT_EQ(numbered_texture(NEAREST, ZERO).get_texel(0, 0, 2), glm::vec4(0.f));
}

TEST(GetTexel, WhiteIsWhiteAtAnyLevel)
{
    EXPECT_EQ(numbered_texture(WHITE, REPEAT).get_texel(99, -7, 7), glm::vec4(1.f));
}

TEST(GetTexel, DebugMipIsTheColourOfTheLevel)
{
    ImageTexture texture(numbered_image(64, 64), DEBUG_MIP, ZERO);
    texture.create_mipmap();
    glm::vec4 const red(1.f, 0.f, 0.f, 0.f);
    EXPECT_EQ(texture.get_texel(0, -5, 1000), red);
    EXPECT_EQ(texture.get_texel(4, 0, 0), glm::vec4(1.f, 0.f, 1.f, 0.f));
    EXPECT_EQ(texture.get_texel(6, 0, 0), red);
}

TEST(GetTexelDeathTest, LevelIsAsserted)
{
    EXPECT_DEATH(numbered_texture(NEAREST, REPEAT).get_texel(1, 0, 0), "assertion failed");
    EXPECT_DEATH(numbered_texture(DEBUG_MIP, REPEAT).get_texel(-1, 0, 0), "assertion failed");
}

TEST(GetTexelDeathTest, NullLevelIsAsserted)
{
    ImageTexture texture = numbered_texture(NEAREST, REPEAT);
    TextureAccess::levels(texture).push_back(nullptr);
    EXPECT_DEATH(texture.get_texel(1, 0, 0), "assertion failed");
}

TEST(SetTexel, WritesWithoutWrapping)
{
    ImageTexture texture = numbered_texture(NEAREST, REPEAT);
    texture.set_texel(0, 1, 1, glm::vec4(9.f));
    EXPECT_EQ(texture.get_texel(0, 1, 1), glm::vec4(9.f));
}

TEST(SetTexelDeathTest, OutsideIsAsserted)
{
    ImageTexture texture = numbered_texture(NEAREST, REPEAT);
    EXPECT_DEATH(texture.set_texel(0, 4, 0, glm::vec4(1.f)), "assertion failed");
    EXPECT_DEATH(texture.set_texel(1, 0, 0, glm::vec4(1.f)), "assertion failed");
}

TEST(ImageTexture, EvaluateFollowsTheFilter)
{
    ImageTexture texture(numbered_image(4, 4), NEAREST, REPEAT);
    texture.create_mipmap();
    glm::vec2 const uv(0.3f, 0.6f);
    glm::vec2 const dudv(0.6f, 0.1f);
    EXPECT_EQ(texture.evaluate(uv, dudv), texture.evaluate_nearest(0, uv));
    texture.filter_mode = BILINEAR;
    EXPECT_EQ(texture.evaluate(uv, dudv), texture.evaluate_bilinear(0, uv));
    texture.filter_mode = TRILINEAR;
    EXPECT_EQ(texture.evaluate(uv, dudv), texture.evaluate_trilinear(uv, dudv));
    texture.filter_mode = DEBUG_MIP;
    EXPECT_EQ(texture.evaluate(uv, dudv).r + texture.evaluate(uv, dudv).g + texture.evaluate(uv, dudv).b, 1.f);
    texture.filter_mode = WHITE;
    EXPECT_EQ(texture.evaluate(uv, dudv), glm::vec4(1.f));
}
