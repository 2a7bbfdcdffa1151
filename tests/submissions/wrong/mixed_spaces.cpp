// verdict: {"loses": {"transform_position": [1, 1], "intersect": [1.75, 2], "transform_direction_to_object_space": [2, 2]}, "says": {"transform_position": "wrong", "intersect": "partial", "transform_direction_to_object_space": "wrong"}, "policy": [], "by_hand": 15, "mistake": {"transform_position": "position_normalised", "intersect": "intersect_t_not_transformed_and_not_back", "transform_direction_to_object_space": "tangent_axes_in_wrong_order"}}
// By GRADING's table of mistakes, the middle where it gives a range:
// transform_position normalises: 1 of 1. intersect leaves t in object space (1 of 2) and does not transform the hit back
// (1 of 2): 2. transform_direction_to_object_space has its axes in the wrong order: 2 of 2.
// 20 - 1 - 2 - 2 = 15
glm::vec3 transform_position(glm::mat4 const& transform, glm::vec3 const& p)
{
    return glm::normalize(glm::vec3(transform * glm::vec4(p, 1.f)));
}

bool Object::intersect(Ray const& ray, Intersection* isect) const
{
    if (!RaytracingContext::get_active()->params.transform_objects)
        return geo->intersect(ray, isect);
    Ray r = transform_ray(ray, transform_world_to_object);
    return geo->intersect(r, isect);
}

glm::vec3 transform_direction_to_object_space(glm::vec3 const& d, glm::vec3 const& normal, glm::vec3 const& tangent,
                                              glm::vec3 const& bitangent)
{
    return glm::normalize(glm::mat3(tangent, bitangent, normal) * d);
}
