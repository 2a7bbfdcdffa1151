// AliasingPlane: a textured plane that reaches to the horizon.
#include <cglib/rt/scenes.h>

#include "scene_textures.h"

std::unique_ptr<Scene> create_plane_scene(AssetLibrary& assets)
{
    auto scene = std::make_unique<Scene>();
    std::shared_ptr<Object> const plane = create_plane(glm::vec3(-5.f, 0.f, 5.f), glm::vec3(0.f, 1.f, 0.f),
                                                       glm::vec3(1.f, 0.f, 0.f), glm::vec3(0.f, 0.f, -1.f), 10.f);
    plane->material->k_d = add_texture(*scene, assets, "checker", Holds::diffuse);
    scene->objects.push_back(plane);
    scene->lights.push_back({glm::vec3(0.f, 1000.f, 0.f), glm::vec3(500000.f)});
    scene->camera = Camera::looking_at(glm::vec3(10.f, 7.f, 10.f), glm::vec3(0.f));
    return scene;
}
