// The pool table: 15 balls in a triangle, each turned at random.
#include <cglib/rt/scenes.h>

#include "draws.h"
#include "scene_textures.h"

#include <fmt/format.h>
#include <glm/gtc/constants.hpp>

namespace {
/// Numbers on the balls, row by row from the tip of the triangle.
int const order[] = {9, 7, 12, 15, 8, 1, 6, 10, 3, 14, 11, 2, 13, 4, 5};
int const rows = 5;
/// Where each row begins, in ball diameters.
float const row_start[rows] = {0.f, -0.5f, -1.f, -1.5f, -2.f};

glm::mat4 random_rotation(Draws& draws)
{
    glm::vec3 axis;
    for (int i = 0; i < 3; ++i)
        axis[i] = draws.next() * 2.f - 1.f;
    float const angle = glm::two_pi<float>() * draws.next();
    return glm::rotate(glm::mat4(1.f), angle, glm::normalize(axis));
}

std::shared_ptr<Object> create_ball(Scene& scene, AssetLibrary& assets, int number)
{
    std::shared_ptr<Object> ball = create_sphere(glm::vec3(0.f), 1.f);
    ball->material->k_d = add_texture(scene, assets, fmt::format("pool_ball_{}", number), Holds::diffuse);
    ball->material->k_s = std::make_shared<ConstTexture>(glm::vec3(1.f));
    ball->material->n = 200.f;
    ball->material->k_r = std::make_shared<ConstTexture>(glm::vec3(0.05f));
    return ball;
}

void add_balls(Scene& scene, AssetLibrary& assets)
{
    Draws draws;
    int const* number = order;
    for (int row = 0; row < rows; ++row)
        for (int j = 0; j <= row; ++j) {
            glm::vec3 const place((row_start[row] + float(j)) * 2.f, 0.f, 2.f * float(row));
            scene.objects.push_back(create_ball(scene, assets, *number++));
            scene.objects.back()->set_transform_object_to_world(glm::translate(glm::mat4(1.f), place) *
                                                                random_rotation(draws));
        }
}

std::shared_ptr<Object> create_table(Scene& scene, AssetLibrary& assets)
{
    std::shared_ptr<Object> table = create_quad(glm::vec3(0.f, -1.f, 0.f), glm::vec3(0.f, 1.f, 0.f),
                                                glm::vec3(80.f, 0.f, 0.f), glm::vec3(0.f, 0.f, -80.f), 4.f);
    table->material->k_d = add_texture(scene, assets, "pool_table", Holds::diffuse);
    return table;
}
}  // namespace

std::unique_ptr<Scene> create_pooltable_scene(AssetLibrary& assets)
{
    auto scene = std::make_unique<Scene>();
    add_balls(*scene, assets);
    scene->objects.push_back(create_table(*scene, assets));
    scene->lights = {{glm::vec3(0.f, 4.f, 4.f), glm::vec3(10.f)},
                     {glm::vec3(-10.f, 4.f, 4.f), glm::vec3(10.f)},
                     {glm::vec3(0.f, 4.f, 16.f), glm::vec3(10.f)}};
    scene->environment = add_texture(*scene, assets, "apartment", Holds::environment);
    scene->camera = Camera::looking_at(glm::vec3(0.f, 12.f, 10.f), glm::vec3(0.f, 0.f, 7.f));
    return scene;
}
