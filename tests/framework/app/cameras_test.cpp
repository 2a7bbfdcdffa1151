#include <viewer/cameras.h>

#include <gtest/gtest.h>

namespace {
using viewer::CameraInput;
using viewer::View;

void expect_near(glm::vec3 const& actual, glm::vec3 const& expected)
{
    EXPECT_LT(glm::length(actual - expected), 1e-4f * (1.f + glm::length(expected)));
}

glm::vec3 target(View const& view)
{
    return view.camera.position() + view.distance * view.camera.forward();
}

/// Looks along -z from (0, 1, 5) at (0, 1, 0).
View view_along_z()
{
    return {Camera::looking_along(glm::vec3(0.f, 1.f, 5.f), glm::vec3(0.f, 0.f, -1.f)), 5.f};
}

CameraInput left_drag(float x, float y)
{
    CameraInput input;
    input.left_drag = glm::vec2(x, y);
    return input;
}
}  // namespace

TEST(Cameras, InitialViewTurnsAroundTheGroundAhead)
{
    View const view = viewer::initial_view(Camera::looking_at(glm::vec3(0.f, 12.f, 10.f), glm::vec3(0.f, 0.f, 7.f)));
    expect_near(target(view), glm::vec3(0.f, 0.f, 7.f));
}

TEST(Cameras, WithoutGroundInitialViewTurnsAroundWhatIsNearTheOrigin)
{
    for (float const up : {0.f, 0.5f}) {
        Camera const camera = Camera::looking_along(glm::vec3(0.f, 1.f, 5.f), glm::vec3(0.f, up, -1.f));
        View const view = viewer::initial_view(camera);
        EXPECT_NEAR(glm::dot(target(view), camera.forward()), 0.f, 1e-4f);
    }
}

TEST(Cameras, WithoutInputViewsStayAsTheyAre)
{
    View const view = viewer::initial_view(Camera::looking_at(glm::vec3(1.f, 2.f, 3.f), glm::vec3(0.f)));
    for (View const& next : {viewer::orbit(view, CameraInput()), viewer::fly(view, CameraInput())}) {
        EXPECT_EQ(next.camera.position(), view.camera.position());
        EXPECT_EQ(next.camera.forward(), view.camera.forward());
        EXPECT_EQ(next.camera.up(), view.camera.up());
    }
}

TEST(Cameras, OrbitKeepsTargetAndDistance)
{
    View view = view_along_z();
    for (int i = 0; i < 100; ++i)
        view = viewer::orbit(view, left_drag(0.03f, i < 50 ? 0.02f : -0.02f));
    expect_near(target(view), glm::vec3(0.f, 1.f, 0.f));
    EXPECT_EQ(view.distance, 5.f);
}

TEST(Cameras, OrbitDragsTheSceneAlong)
{
    // What is dragged to the right is seen from further left.
    EXPECT_LT(viewer::orbit(view_along_z(), left_drag(0.1f, 0.f)).camera.position().x, 0.f);
    EXPECT_LT(viewer::orbit(view_along_z(), left_drag(0.f, 0.1f)).camera.position().y, 1.f);
}

TEST(Cameras, NeitherTurnsOverThePole)
{
    for (auto const move : {&viewer::orbit, &viewer::fly})
        for (float const drag : {10.f, -10.f}) {
            View const view = move(view_along_z(), left_drag(0.f, drag));
            EXPECT_GT(view.camera.up().y, 0.f);
            EXPECT_GT(view.camera.forward().y * drag, 0.f);
            expect_near(view.camera.right(), glm::vec3(1.f, 0.f, 0.f));
        }
}

TEST(Cameras, WheelGoesNearerButNotThrough)
{
    CameraInput input;
    input.wheel = 3.f;
    View view = viewer::orbit(view_along_z(), input);
    EXPECT_LT(view.distance, 5.f);
    expect_near(target(view), glm::vec3(0.f, 1.f, 0.f));
    input.wheel = 1e6f;
    EXPECT_GT(viewer::orbit(view, input).distance, 0.f);
}

TEST(Cameras, MiddleDragShiftsTheTargetWithTheMouse)
{
    CameraInput input;
    input.middle_drag = glm::vec2(0.2f, 0.1f);
    View const view = viewer::orbit(view_along_z(), input);
    expect_near(target(view), glm::vec3(-1.f, 0.5f, 0.f));
    expect_near(view.camera.forward(), glm::vec3(0.f, 0.f, -1.f));
}

TEST(Cameras, FlyTurnsOnTheSpot)
{
    View const view = viewer::fly(view_along_z(), left_drag(0.1f, 0.1f));
    expect_near(view.camera.position(), glm::vec3(0.f, 1.f, 5.f));
    EXPECT_GT(view.camera.forward().x, 0.f);
    EXPECT_GT(view.camera.forward().y, 0.f);
}

TEST(Cameras, FlyGoesWhereTheKeysSay)
{
    CameraInput input;
    input.walked = glm::vec3(2.f, 1.f, 4.f);
    View const view = viewer::fly(view_along_z(), input);
    expect_near(view.camera.position(), glm::vec3(5.f, 3.5f, -5.f));
    expect_near(view.camera.forward(), glm::vec3(0.f, 0.f, -1.f));
}
