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
    Image image;
    for (std::string const& name : scene_names()) {
        std::unique_ptr<Scene> const scene = create_scene(name, assets);
        EXPECT_THROW(render_scene(*scene, RaytracingParameters(), &image), std::runtime_error) << name;
    }
}

TEST(PlaneScene, HasOneTextureThatIsNotLoadedYet)
{
    AssetLibrary assets(assets_directory());
    std::unique_ptr<Scene> const scene = create_scene("plane", assets);
    ASSERT_EQ(scene->textures.size(), 1u);
    EXPECT_EQ(scene->textures[0].texture->get_mip_levels().size(), 0u);
    EXPECT_EQ(scene->textures[0].load()->getWidth(), 128);
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

TEST(GoBoardScene, HasABoardAndAsManyBlackStonesAsWhite)
{
    AssetLibrary assets(assets_directory());
    std::unique_ptr<Scene> const scene = create_scene("goboard", assets);
    ASSERT_EQ(scene->objects.size(), 83u);
    int black = 0;
    for (std::size_t i = 1; i < scene->objects.size(); ++i)
        black += scene->objects[i]->material->k_d->evaluate(glm::vec2(0.f)).r < 0.1f ? 1 : 0;
    EXPECT_EQ(black, 41);
}

TEST(GoBoardScene, StonesLieFlatOnTheBoardAndDoNotTouch)
{
    AssetLibrary assets(assets_directory());
    std::unique_ptr<Scene> const scene = create_scene("goboard", assets);
    for (std::size_t i = 1; i < scene->objects.size(); ++i) {
        Object const& stone = *scene->objects[i];
        Bounds const bounds = stone.geo->bounds(stone.transform_object_to_world);
        EXPECT_NEAR(bounds.lower.y, 0.f, 1e-5f);
        EXPECT_NEAR(bounds.upper.y, 2.3f, 0.02f);
        for (std::size_t j = 1; j < i; ++j) {
            glm::vec3 const apart(stone.transform_object_to_world[3] - scene->objects[j]->transform_object_to_world[3]);
            EXPECT_GT(glm::length(apart), 4.5f);
        }
    }
}

TEST(PoolTableScene, BallsFormATriangle)
{
    AssetLibrary assets(assets_directory());
    std::unique_ptr<Scene> const scene = create_scene("pooltable", assets);
    ASSERT_EQ(scene->objects.size(), 16u);
    EXPECT_EQ(glm::vec3(scene->objects[0]->transform_object_to_world[3]), glm::vec3(0.f));
    EXPECT_EQ(glm::vec3(scene->objects[10]->transform_object_to_world[3]), glm::vec3(-4.f, 0.f, 8.f));
    EXPECT_EQ(glm::vec3(scene->objects[14]->transform_object_to_world[3]), glm::vec3(4.f, 0.f, 8.f));
    EXPECT_EQ(scene->textures.size(), 17u);
}

TEST(SphereScene, BothObjectsHaveNormalMaps)
{
    AssetLibrary assets(assets_directory());
    std::unique_ptr<Scene> const scene = create_scene("sphere", assets);
    for (auto const& object : scene->objects)
        EXPECT_TRUE(object->material->has_normal_map());
}
