// Not on the sheet: triangles with interpolated texture coordinates, and glass.
#include <cglib/rt/scenes.h>
#include <cglib/rt/triangle_mesh.h>

#include "scene_textures.h"

namespace {
/// An octahedron whose faces show the texture between the middle of its lower edge and its upper corners.
std::shared_ptr<TriangleMesh> create_octahedron()
{
    std::vector<TriangleMesh::Vertex> vertices;
    std::vector<TriangleMesh::Triangle> triangles;
    glm::vec3 const ring[] = {{1.f, 0.f, 0.f}, {0.f, 0.f, -1.f}, {-1.f, 0.f, 0.f}, {0.f, 0.f, 1.f}};
    for (int side = 0; side < 4; ++side)
        for (float const height : {1.f, -1.f}) {
            int const first = int(vertices.size());
            vertices.push_back({glm::vec3(0.f, height, 0.f), glm::vec2(0.5f, 0.f)});
            vertices.push_back({ring[side], glm::vec2(0.f, 1.f)});
            vertices.push_back({ring[(side + 1) % 4], glm::vec2(1.f, 1.f)});
            bool const upper = height > 0.f;
            triangles.push_back({first, first + (upper ? 1 : 2), first + (upper ? 2 : 1)});
        }
    return std::make_shared<TriangleMesh>(std::move(vertices), std::move(triangles));
}

std::shared_ptr<Object> create_gem(Scene& scene, AssetLibrary& assets)
{
    auto const mesh = create_octahedron();
    auto gem = std::make_shared<Object>(mesh, std::make_shared<MeshMapping>(mesh));
    gem->material->k_d = add_texture(scene, assets, "stonewall_diffuse", Holds::diffuse);
    gem->material->normal = add_texture(scene, assets, "stonewall_normal", Holds::normals);
    gem->set_transform_object_to_world(
        glm::scale(glm::translate(glm::mat4(1.f), glm::vec3(-1.2f, 1.6f, 0.f)), glm::vec3(1.4f, 1.6f, 1.4f)));
    return gem;
}

std::shared_ptr<Object> create_glass_ball()
{
    std::shared_ptr<Object> ball = create_sphere(glm::vec3(1.5f, 1.f, 0.6f), 1.f);
    ball->material->k_d = std::make_shared<ConstTexture>(glm::vec3(0.f));
    ball->material->k_t = std::make_shared<ConstTexture>(glm::vec3(0.95f));
    ball->material->eta = 1.5f;
    return ball;
}

std::shared_ptr<Object> create_floor(Scene& scene, AssetLibrary& assets)
{
    std::shared_ptr<Object> floor = create_plane(glm::vec3(0.f), glm::vec3(0.f, 1.f, 0.f), glm::vec3(1.f, 0.f, 0.f),
                                                 glm::vec3(0.f, 0.f, -1.f), 8.f);
    floor->material->k_d = add_texture(scene, assets, "checker", Holds::diffuse);
    return floor;
}
}  // namespace

std::unique_ptr<Scene> create_triangles_scene(AssetLibrary& assets)
{
    auto scene = std::make_unique<Scene>();
    scene->objects = {create_gem(*scene, assets), create_glass_ball(), create_floor(*scene, assets)};
    scene->lights = {{glm::vec3(3.f, 6.f, 4.f), glm::vec3(40.f)}, {glm::vec3(-4.f, 3.f, 5.f), glm::vec3(8.f)}};
    scene->environment = add_texture(*scene, assets, "apartment", Holds::environment);
    scene->camera = Camera::looking_at(glm::vec3(0.5f, 3.f, 6.f), glm::vec3(0.f, 1.1f, 0.f));
    return scene;
}
