// verdict: {"loses": {"intersect": [2, 2]}, "says": {"intersect": "wrong"}, "policy": [], "mistake": {"intersect": "intersect_transforms_ray_with_object_to_world"}}
// The wrong one of the two matrices for the ray.
bool Object::intersect(Ray const& ray, Intersection* isect) const
{
    if (!RaytracingContext::get_active()->params.transform_objects)
        return geo->intersect(ray, isect);
    Ray r = transform_ray(ray, transform_object_to_world);
    if (!geo->intersect(r, isect))
        return false;
    *isect = transform_intersection(*isect, transform_object_to_world, transform_object_to_world_normal);
    isect->t = glm::length(isect->position - ray.origin);
    return true;
}
