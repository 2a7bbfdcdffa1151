// The Go board: 82 stones that are spheres flattened by their transforms.
#include <cglib/rt/scenes.h>

#include "draws.h"
#include "scene_textures.h"

namespace {
/// Between two lines of the board.
float const line_distance = 4.78515625f;
int const lines = 19;

/// An opening and the fights after it, of our own: X is black, O is white.
char const* const position[lines] = {
    ". . . . . . . . . . . . . . . . . . .",  //
    ". . . O O . . . . . . . . . X . . . .",  //
    ". . O X X O . . . X . . . . X O O . .",  //
    ". . O X . . . O . . . . . X . X O . .",  //
    ". . . X . X . . . . . . . . . X X O .",  //
    ". . X . . . . . . . . . . . . . O . .",  //
    ". . . . O . . . . . . O . . . . O . .",  //
    ". . X . . . . . . . . . . . . . X . .",  //
    ". . . . . . . . . . O . X . . . . . .",  //
    ". . . O . . . . . . O X . . . . . X .",  //
    ". . . . . . . . . O X X . . . . O O .",  //
    ". . X . . . . . . O O X O . . . X X .",  //
    ". . . . O . . . . O X O . . . . . . .",  //
    ". . O . . . . . . . X . O . . O . . .",  //
    ". . O X X . . . . . X . . . . . O . .",  //
    ". . X O X . X . . O . X . . O O X . .",  //
    ". . . O O X . . . X . . . O X X X . .",  //
    ". . . O O X . . . . . . . O X . . . .",  //
    ". . . . . . . . . . . . . . . . . . .",  //
};

std::shared_ptr<Material> stone_material(float k_d, float k_r)
{
    auto material = std::make_shared<Material>();
    material->k_d = std::make_shared<ConstTexture>(glm::vec3(k_d));
    material->k_r = std::make_shared<ConstTexture>(glm::vec3(k_r));
    return material;
}

/// No two stones are the same size, or exactly on their crossing.
std::shared_ptr<Object> create_stone(int x, int y, Draws& draws)
{
    float const radius = 2.3f + 0.01f * draws.next();
    float const off_x = (draws.next() - 0.5f) * 0.25f;
    float const off_y = (draws.next() - 0.5f) * 0.25f;
    glm::vec3 const place(float(x - 9) * line_distance + off_x, radius / 2.f, float(y - 9) * line_distance + off_y);
    std::shared_ptr<Object> stone = create_sphere(glm::vec3(0.f), radius);
    stone->set_transform_object_to_world(glm::scale(glm::translate(glm::mat4(1.f), place), glm::vec3(1.f, 0.5f, 1.f)));
    return stone;
}

void add_stones(Scene& scene)
{
    auto const black = stone_material(0.025f, 0.015f);
    auto const white = stone_material(0.9f, 0.08f);
    Draws draws;
    for (int y = 0; y < lines; ++y)
        for (int x = 0; x < lines; ++x) {
            char const colour = position[y][2 * x];
            if (colour == '.')
                continue;
            scene.objects.push_back(create_stone(x, y, draws));
            scene.objects.back()->material = colour == 'X' ? black : white;
        }
}

std::shared_ptr<Object> create_board(Scene& scene, AssetLibrary& assets)
{
    std::shared_ptr<Object> board = create_quad(glm::vec3(0.f), glm::vec3(0.f, 1.f, 0.f), glm::vec3(0.f, 0.f, 100.f),
                                                glm::vec3(100.f, 0.f, 0.f), 10000.f);
    board->material->k_d = add_texture(scene, assets, "go_board_diffuse", Holds::diffuse);
    board->material->normal = add_texture(scene, assets, "go_board_normal", Holds::normals);
    board->material->k_r = std::make_shared<ConstTexture>(glm::vec3(0.1f));
    return board;
}
}  // namespace

std::unique_ptr<Scene> create_goboard_scene(AssetLibrary& assets)
{
    auto scene = std::make_unique<Scene>();
    scene->objects.push_back(create_board(*scene, assets));
    add_stones(*scene);
    scene->lights = {{glm::vec3(0.f, 100.f, 0.f), glm::vec3(5000.f, 4000.f, 4000.f)},
                     {glm::vec3(-200.f, 300.f, 0.f), glm::vec3(1250.f)},
                     {glm::vec3(-150.f, 300.f, 200.f), glm::vec3(1250.f)}};
    scene->environment = add_texture(*scene, assets, "warehouse", Holds::environment);
    scene->camera =
        Camera::looking_along(glm::vec3(44.24f, 12.1067f, 53.164f), glm::vec3(-0.513036f, -0.309281f, -0.800712f));
    return scene;
}
