// verdict: {"loses": {"transform_direction": [0.5, 0.5], "intersect": [1, 1], "transform_direction_to_object_space": [0.5, 0.5]}, "says": {"transform_direction": "partial", "intersect": "partial", "transform_direction_to_object_space": "partial"}, "policy": [], "by_hand": 18, "mistake": {"transform_direction": "direction_not_normalised", "intersect": "intersect_leaves_t_in_object_space", "transform_direction_to_object_space": "tangent_not_normalised"}}
// By GRADING's table of mistakes, the middle where it gives a range:
// transform_direction does not normalise: 0.5 of 1. transform_direction_to_object_space does not either: 0.5 of 2. intersect
// leaves t in object space: 1 of 2.
// 20 - 0.5 - 0.5 - 1 = 18
glm::vec3 transform_direction(glm::mat4 const& transform, glm::vec3 const& d)
{
    return glm::vec3(transform * glm::vec4(d, 0.f));
}

bool Object::intersect(Ray const& ray, Intersection* isect) const
{
    if (!RaytracingContext::get_active()->params.transform_objects)
        return geo->intersect(ray, isect);
    Ray const object_ray = transform_ray(ray, transform_world_to_object);
    if (!geo->intersect(object_ray, isect))
        return false;
    *isect = transform_intersection(*isect, transform_object_to_world, transform_object_to_world_normal);
    return true;
}

glm::vec3 transform_direction_to_object_space(glm::vec3 const& d, glm::vec3 const& normal, glm::vec3 const& tangent,
                                              glm::vec3 const& bitangent)
{
    return glm::mat3(tangent, normal, bitangent) * d;
}
