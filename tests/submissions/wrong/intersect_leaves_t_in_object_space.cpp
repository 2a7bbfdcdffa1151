// verdict: {"loses": {"intersect": [1, 1]}, "says": {"intersect": "partial"}, "policy": [], "mistake": {"intersect": "intersect_leaves_t_in_object_space"}}
// t stays the distance in object space.
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
