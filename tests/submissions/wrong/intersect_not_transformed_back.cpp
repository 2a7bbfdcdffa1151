// verdict: {"loses": {"intersect": [1, 1]}, "says": {"intersect": "partial"}, "policy": [], "mistake": {"intersect": "intersect_not_transformed_back"}}
// Position and normals stay in object space; t is right.
bool Object::intersect(Ray const& ray, Intersection* isect) const
{
    if (!RaytracingContext::get_active()->params.transform_objects)
        return geo->intersect(ray, isect);
    Ray const object_ray = transform_ray(ray, transform_world_to_object);
    if (!geo->intersect(object_ray, isect))
        return false;
    isect->t = glm::length(transform_position(transform_object_to_world, isect->position) - ray.origin);
    return true;
}
