// TexturedSphere: a ball of stone on a floor of concrete, with normal maps.
#include <cglib/rt/scenes.h>

#include "scene_textures.h"

std::unique_ptr<Scene> create_sphere_scene(AssetLibrary& assets)
{
    auto scene = std::make_unique<Scene>();
    std::shared_ptr<Object> const sphere = create_sphere(glm::vec3(0.f), 2.f, 5.f);
    sphere->material->k_d = add_texture(*scene, assets, "stonewall_diffuse", Holds::diffuse);
    sphere->material->normal = add_texture(*scene, assets, "stonewall_normal", Holds::normals);
    std::shared_ptr<Object> const floor = create_plane(glm::vec3(0.f, -2.f, 0.f), glm::vec3(0.f, 1.f, 0.f),
                                                       glm::vec3(1.f, 0.f, 0.f), glm::vec3(0.f, 0.f, -1.f), 4.f);
    floor->material->k_d = add_texture(*scene, assets, "concrete_diffuse", Holds::diffuse);
    floor->material->normal = add_texture(*scene, assets, "concrete_normal", Holds::normals);
    scene->objects = {sphere, floor};
    scene->lights = {{glm::vec3(3.f, 4.f, 2.f), glm::vec3(10.f)}, {glm::vec3(0.f, 4.f, 5.f), glm::vec3(1.f)}};
    scene->camera = Camera::looking_at(glm::vec3(3.f, 4.f, 5.f), glm::vec3(0.f));
    return scene;
}
