#include <cglib/rt/scenes.h>

#include <cglib/core/build_paths.h>
#include <cglib/rt/assignment_images.h>
#include <cglib/rt/renderer.h>

#include <gtest/gtest.h>

#include <stdexcept>

namespace {
Image picture(std::string const& name)
{
    AssetLibrary assets(assets_directory());
    Image image;
    for (AssignmentImage const& assignment : assignment_images())
        if (assignment.name == name)
            render_scene(*create_scene(assignment.scene, assets), assignment.params, &image);
    return image;
}

bool is_black(glm::vec4 const& pixel)
{
    return glm::vec3(pixel) == glm::vec3(0.f);
}
}  // namespace

TEST(Scenes, UnknownNameListsTheKnownOnes)
{
    AssetLibrary assets(assets_directory());
    try {
        create_scene("moon", assets);
        FAIL() << "nothing was thrown";
    } catch (std::invalid_argument const& error) {
        EXPECT_NE(std::string(error.what()).find("plane"), std::string::npos);
    }
}

TEST(Scenes, MissingTextureIsAnError)
{
    AssetLibrary assets("/nowhere");
    EXPECT_THROW(create_scene("plane", assets), std::runtime_error);
}

TEST(PlaneScene, HasOneTextureOfOneLevel)
{
    AssetLibrary assets(assets_directory());
    std::unique_ptr<Scene> const scene = create_scene("plane", assets);
    ASSERT_EQ(scene->textures.size(), 1u);
    ASSERT_EQ(scene->textures[0]->get_mip_levels().size(), 1u);
    EXPECT_EQ(scene->textures[0]->get_mip_levels()[0]->getWidth(), 128);
    EXPECT_EQ(scene->camera.position(), glm::vec3(10.f, 7.f, 10.f));
}

TEST(PlaneScene, ZeroShowsOneTileAroundTheOrigin)
{
    Image const image = picture("plane_after_a_zero");
    EXPECT_FALSE(is_black(image.getPixel(128, 128)));
    EXPECT_TRUE(is_black(image.getPixel(2, 128)));
    EXPECT_TRUE(is_black(image.getPixel(128, 5)));
}

TEST(PlaneScene, RepeatIsLitUpToTheHorizon)
{
    Image const image = picture("plane_after_b_repeat");
    for (int y = 0; y < 250; ++y)
        EXPECT_FALSE(is_black(image.getPixel(77, y))) << y;
}

TEST(PlaneScene, ModesAgreeInsideTheTile)
{
    Image const zero = picture("plane_after_a_zero");
    EXPECT_EQ(zero.getPixel(128, 120), picture("plane_after_b_clamp").getPixel(128, 120));
    EXPECT_EQ(zero.getPixel(128, 120), picture("plane_after_b_repeat").getPixel(128, 120));
}

TEST(PlaneScene, DebugMipIsRedNearTheCamera)
{
    glm::vec4 const near = picture("plane_after_d_debugmip").getPixel(128, 5);
    EXPECT_GT(near.r, 0.f);
    EXPECT_EQ(near.g, 0.f);
    EXPECT_EQ(near.b, 0.f);
}

TEST(PlaneScene, FootprintsGrowTowardsTheHorizon)
{
    Image const image = picture("plane_after_d_dudv");
    EXPECT_EQ(image.getPixel(128, 5).b, 1.f);
    EXPECT_EQ(glm::vec3(image.getPixel(128, 252)), glm::vec3(1.f, 0.f, 0.f));
}
