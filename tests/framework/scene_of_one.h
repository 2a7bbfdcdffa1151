#pragma once

#include <cglib/rt/scene.h>

/// A grey sphere of radius 1 at the origin, seen along -z from (0, 0, 4), without lights.
inline Scene scene_of_one_sphere()
{
    Scene scene;
    scene.objects.push_back(create_sphere(glm::vec3(0.f), 1.f));
    scene.camera = Camera::looking_at(glm::vec3(0.f, 0.f, 4.f), glm::vec3(0.f));
    return scene;
}
