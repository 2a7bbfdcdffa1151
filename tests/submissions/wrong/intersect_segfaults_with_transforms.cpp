// verdict: {"loses": {"intersect": [2, 2]}, "says": {"intersect": "crashed"}, "policy": ["crashes"]}
// SIGSEGV, but only with transform_objects.
bool Object::intersect(Ray const& ray, Intersection* isect) const
{
    if (!RaytracingContext::get_active()->params.transform_objects)
        return geo->intersect(ray, isect);
    Ray const object_ray = transform_ray(ray, transform_world_to_object);
    if (!geo->intersect(object_ray, isect))
        return false;
    Intersection* volatile world = nullptr;
    *world = transform_intersection(*isect, transform_object_to_world, transform_object_to_world_normal);
    isect->t = glm::length(world->position - ray.origin);
    return true;
}
