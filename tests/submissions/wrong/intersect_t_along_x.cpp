// verdict: {"loses": {"intersect": [1, 1]}, "says": {"intersect": "partial"}, "policy": []}
// t from the first coordinate alone: a division by a number near 0, or by 0.
bool Object::intersect(Ray const& ray, Intersection* isect) const
{
    if (!RaytracingContext::get_active()->params.transform_objects)
        return geo->intersect(ray, isect);
    Ray object_ray = transform_ray(ray, transform_world_to_object);
    if (!geo->intersect(object_ray, isect))
        return false;
    *isect = transform_intersection(*isect, transform_object_to_world, transform_object_to_world_normal);
    isect->t = (isect->position.x - ray.origin.x) / ray.direction.x;
    return true;
}
